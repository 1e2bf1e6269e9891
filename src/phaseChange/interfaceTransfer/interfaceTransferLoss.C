/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Where the liquid loses what goes through the faces

#include "interfaceTransfer.H"
#include "bitSet.H"
#include "gaussGrad.H"
#include "neighbourSum.H"
#include "surfaceMotion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Values of either sign, in proportion to their size, to a sum of all ranks
void scaleTo(const Foam::scalar wanted, Foam::scalarField& values)
{
    const Foam::scalar size = Foam::gSum(Foam::mag(values));
    if (size > 0)
    {
        const Foam::scalar share = (wanted - Foam::gSum(values))/size;
        values += share*Foam::mag(values);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::dew::interfaceTransfer::cellArea() const
{
    if (!law_->smeared())
    {
        return tmp<scalarField>(new scalarField(surface_.area()));
    }
    return
        mesh_.V()
       *mag(fv::gaussGrad<scalar>(mesh_).grad(surface_.alpha())().primitiveField());
}


void Foam::dew::interfaceTransfer::weigh
(
    const scalarField& area,
    scalarField& loss
) const
{
    const scalarField& alpha = surface_.alpha().primitiveField();
    scalarField share(alpha.size());
    forAll(share, celli)
    {
        share[celli] = law_->share(alpha[celli]);
    }
    if (gMin(share) > 1 - SMALL)
    {
        return;
    }

    // Where no cell has a weight, as of a surface between cells, the loss stays
    if (law_->local())
    {
        share *= area;
        const scalarField around(share + neighbourSum<scalar>(mesh_, share));
        scalarField part(loss.size(), Zero), stays(loss);
        forAll(part, celli)
        {
            if (around[celli] > VSMALL)
            {
                part[celli] = loss[celli]/around[celli];
                stays[celli] = 0;
            }
        }
        loss = stays + share*(part + neighbourSum<scalar>(mesh_, part));
        return;
    }

    const scalarField weighed(share*loss);
    if (gSum(mag(weighed)) > 1e-6*gSum(mag(loss)))
    {
        const scalar whole = gSum(loss);
        loss = weighed;
        scaleTo(whole, loss);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::interfaceTransfer::distribute()
{
    const auto& faces = faces_.faces();

    // The surface was here over the step, and is there now
    const scalarField area(0.5*(area_ + cellArea()));

    // Best fit of N = J n.e: J = sum S N n.e/sum S (n.e)^2
    scalarField above(mesh_.nCells(), Zero), below(mesh_.nCells(), Zero);
    scalarField sideAbove(faces.size()), sideBelow(faces.size());
    forAll(faces, k)
    {
        const interfaceFace& face = faces[k];
        const scalar c = cosine(face);
        sideAbove[k] = face.S*total_[k]*c;
        sideBelow[k] = face.S*c*c;
        above[face.gas] += sideAbove[k];
        below[face.gas] += sideBelow[k];
    }
    faces_.toLiquid(sideAbove, above);
    faces_.toLiquid(sideBelow, below);

    // By the faces of the cell itself: the flux at a contact line is not that
    // of its neighbours. A cell that only touches the surface may have none,
    // and takes those of its neighbours, or of theirs
    const label nRounds = 4;
    scalarField J(mesh_.nCells(), Zero);
    bitSet found(mesh_.nCells());
    for (label round = 0; round < nRounds; round++)
    {
        if (round > 0)
        {
            above += neighbourSum<scalar>(mesh_, above);
            below += neighbourSum<scalar>(mesh_, below);
        }

        bool all = true;
        forAll(area, celli)
        {
            if (area[celli] > 0 && !found.test(celli))
            {
                if (below[celli] > VSMALL)
                {
                    J[celli] = above[celli]/below[celli];
                    found.set(celli);
                }
                else
                {
                    all = false;
                }
            }
        }
        if (returnReduce(all, andOp<bool>()))
        {
            break;
        }
    }

    scalarField loss(J*area);
    scaleTo(rate_, loss);
    weigh(area, loss);
    mDot_.field() = loss/mesh_.V();
}


// ************************************************************************* //
