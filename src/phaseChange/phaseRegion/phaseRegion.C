/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "phaseRegion.H"
#include "interfaceFaces.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::phaseRegion::phaseRegion
(
    const fvMesh& mesh,
    const interfaceFaces& faces,
    const side s
)
:
    mesh_(mesh),
    faces_(faces),
    side_(s),
    share_(mesh.nCells(), Zero),
    own_(mesh.nCells(), Zero),
    V_(mesh.nCells(), Zero),
    allWeights_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dew::phaseRegion::inside(const label celli) const
{
    return faces_.gas()[celli] == (side_ == side::gas);
}


void Foam::dew::phaseRegion::toCells
(
    const UList<scalar>& values,
    scalarField& cells,
    const bool other
) const
{
    if ((side_ == side::liquid) != other)
    {
        faces_.toLiquid(values, cells);
        return;
    }
    forAll(values, k)
    {
        cells[faces_.faces()[k].gas] += values[k];
    }
}


Foam::scalarField Foam::dew::phaseRegion::onFaces
(
    const scalarField& cells,
    const bool other
) const
{
    const auto& faces = faces_.faces();
    scalarField values(faces.size());
    if ((side_ == side::liquid) == other)
    {
        forAll(values, k)
        {
            values[k] = cells[faces[k].gas];
        }
        return values;
    }

    volScalarField field
    (
        IOobject("cells", mesh_.time().timeName(), mesh_, IOobject::NO_READ,
            IOobject::NO_WRITE, false),
        mesh_,
        dimensionedScalar(dimless, Zero)
    );
    field.primitiveFieldRef() = cells;
    field.correctBoundaryConditions();
    values = faces_.ofLiquid(field);
    forAll(values, k)
    {
        if (faces[k].wall)
        {
            values[k] = 0;
        }
    }
    return values;
}


Foam::scalarField Foam::dew::phaseRegion::beyondOf
(
    const scalarField& cells
) const
{
    scalarField perWeight(mesh_.nCells(), Zero);
    forAll(perWeight, celli)
    {
        if (weightOf_[celli] > VSMALL)
        {
            perWeight[celli] = cells[celli]/weightOf_[celli];
        }
    }
    return w_*onFaces(perWeight, true);
}


void Foam::dew::phaseRegion::correctWeights()
{
    const auto& faces = faces_.faces();

    w_.setSize(faces.size());
    forAll(faces, k)
    {
        // A wall has no cell of liquid behind it
        w_[k] =
            faces[k].wall && side_ == side::liquid
          ? 0
          : faces[k].S*mag(faces[k].n & faces[k].e);
    }
    allWeights_ = gSum(w_);

    weightOf_.setSize(mesh_.nCells());
    weightOf_ = 0;
    if (side_ == side::gas)
    {
        faces_.toLiquid(w_, weightOf_);
    }
    else
    {
        forAll(faces, k)
        {
            weightOf_[faces[k].gas] += w_[k];
        }
    }
}


void Foam::dew::phaseRegion::correctProfile()
{
    const auto& faces = faces_.faces();
    beyond_ = beyondOf(own_);
    depth_ = beyondOf(share_*mesh_.V());
    forAll(depth_, k)
    {
        const scalar d = side_ == side::gas ? faces[k].dG : faces[k].dL;
        depth_[k] = min(0.5*depth_[k]/max(d*w_[k], VSMALL), scalar(1));
    }

    // Away from the surface
    vectorField inwards(mesh_.nCells());
    for (direction cmpt = 0; cmpt < vector::nComponents; cmpt++)
    {
        scalarField values(faces.size());
        forAll(faces, k)
        {
            values[k] =
                w_[k]*faces[k].n[cmpt]*(side_ == side::gas ? 1 : -1);
        }
        scalarField sums(mesh_.nCells(), Zero);
        toCells(values, sums);
        inwards.replace(cmpt, sums);
    }

    offset_.setSize(mesh_.nCells());
    offset_ = 0;
    forAll(offset_, celli)
    {
        if (inside(celli) && inwards[celli] != vector::zero)
        {
            offset_[celli] = 0.5*max(1 - share_[celli], scalar(0));
        }
    }

    further_.clear();
    scalarField sum(mesh_.nCells(), Zero);
    const auto see = [&]
    (
        const label celli, const label next, const label patch,
        const vector& S, const scalar same
    )
    {
        const scalar w = same*(S & inwards[celli]);
        if (w > 0)
        {
            further_.append({celli, next, patch, w});
            sum[celli] += w;
        }
    };
    const surfaceVectorField& Sf = mesh_.Sf();
    const surfaceScalarField& same = faces_.sameSide();
    forAll(mesh_.owner(), facei)
    {
        const label P = mesh_.owner()[facei];
        const label N = mesh_.neighbour()[facei];
        see(P, N, -1, Sf[facei], same[facei]);
        see(N, P, -1, -Sf[facei], same[facei]);
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        const label patchi = patch.index();
        for (label i = 0; i < patch.size() && patch.coupled(); i++)
        {
            see
            (
                patch.faceCells()[i], i, patchi,
                Sf.boundaryField()[patchi][i], same.boundaryField()[patchi][i]
            );
        }
    }
    for (further& f : further_)
    {
        f.weight /= sum[f.cell];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::phaseRegion::correct
(
    const scalarField& share,
    const scalarField& fluids
)
{
    share_ = share;
    own_ = share*fluids*mesh_.V();

    correctWeights();
    correctProfile();

    V_.setSize(mesh_.nCells());
    V_ = 0;
    V_ = collect(own_/mesh_.V());
}


Foam::tmp<Foam::scalarField> Foam::dew::phaseRegion::furtherIn
(
    const volScalarField& f
) const
{
    List<scalarField> across(mesh_.boundary().size());
    forAll(across, patchi)
    {
        if (mesh_.boundary()[patchi].coupled())
        {
            across[patchi] = f.boundaryField()[patchi].patchNeighbourField();
        }
    }

    auto tvalues = tmp<scalarField>::New(f.primitiveField());
    scalarField& values = tvalues.ref();
    for (const further& cell : further_)
    {
        values[cell.cell] = 0;
    }
    for (const further& cell : further_)
    {
        values[cell.cell] +=
            cell.weight
           *(
                cell.patch < 0 ? f[cell.next] : across[cell.patch][cell.next]
            );
    }
    return tvalues;
}


Foam::tmp<Foam::scalarField> Foam::dew::phaseRegion::collect
(
    const scalarField& densities
) const
{
    auto tall = tmp<scalarField>::New(mesh_.nCells(), Zero);
    scalarField& all = tall.ref();

    scalarField perWeight(mesh_.nCells(), Zero);
    scalar unassigned = 0;
    forAll(all, celli)
    {
        const scalar content = densities[celli]*mesh_.V()[celli];
        if (inside(celli))
        {
            all[celli] = content;
        }
        else if (weightOf_[celli] > VSMALL)
        {
            perWeight[celli] = content/weightOf_[celli];
        }
        else
        {
            unassigned += content;
        }
    }
    reduce(unassigned, sumOp<scalar>());

    scalarField parts(onFaces(perWeight, true));
    if (allWeights_ > VSMALL)
    {
        parts += unassigned/allWeights_;
    }
    else if (unassigned != 0)
    {
        const scalar V = gSum(V_);
        if (V > 0)
        {
            all += unassigned*V_/V;
        }
    }
    toCells(parts*w_, all);

    return tall;
}


Foam::tmp<Foam::scalarField> Foam::dew::phaseRegion::giveBack
(
    const scalarField& contents
) const
{
    auto tdensities = tmp<scalarField>::New(mesh_.nCells(), Zero);
    scalarField& densities = tdensities.ref();

    scalarField perVolume(mesh_.nCells(), Zero);
    forAll(perVolume, celli)
    {
        if (V_[celli] > 0)
        {
            perVolume[celli] = contents[celli]/V_[celli];
        }
    }

    // Means over the faces, for cells of the other side
    const scalarField wOf(w_*onFaces(perVolume, false));
    const scalar mean = allWeights_ > VSMALL ? gSum(wOf)/allWeights_ : 0;
    scalarField sum(mesh_.nCells(), Zero);
    if (side_ == side::gas)
    {
        faces_.toLiquid(wOf, sum);
    }
    else
    {
        forAll(wOf, k)
        {
            sum[faces_.faces()[k].gas] += wOf[k];
        }
    }

    forAll(densities, celli)
    {
        densities[celli] =
            own_[celli]/mesh_.V()[celli]
           *(
                inside(celli) ? perVolume[celli]
              : weightOf_[celli] > VSMALL ? sum[celli]/weightOf_[celli]
              : mean
            );
    }

    return tdensities;
}


Foam::scalarField Foam::dew::phaseRegion::shares() const
{
    return allWeights_ > VSMALL ? scalarField(w_/allWeights_) : scalarField();
}


// ************************************************************************* //
