/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// From the faces between gas and liquid to the cells on both sides

#include "interfaceTransfer.H"
#include "gasMixture.H"
#include "liquidPhase.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::interfaceTransfer::heat
(
    const volScalarField& T,
    const bool last,
    volScalarField::Internal& Su,
    volScalarField::Internal& Sp,
    surfaceScalarField& kappaf
) const
{
    const auto& faces = faces_.faces();
    const label n = size();
    const surfaceScalarField& delta = mesh_.nonOrthDeltaCoeffs();

    scalarField liquidSu(faces.size()), liquidSp(faces.size());

    forAll(faces, k)
    {
        const interfaceFace& face = faces[k];
        const bool fixed = law_->fixedTs() > 0;
        scalar heatOf, slope;
        latent
        (
            SubList<scalar>(N_, n, k*n), SubList<scalar>(dNdTs_, n, k*n),
            Ts_[k], heatOf, slope
        );
        slope *= last ? 0 : face.S;
        const scalar sum = KG_[k] + KL_[k] + slope;
        const scalar latentHeat = heatOf*face.S - slope*Ts_[k];

        const scalar conductance = fixed ? 0 : KG_[k]*KL_[k]/sum;

        // Of what each side brings, the share that the surface takes, and what
        // it gives by itself
        const scalar takes = fixed ? 1 : slope/sum;
        const scalar gives = fixed ? Ts_[k] : -latentHeat/sum;
        // Beside what a wall conducts to the gas
        if (face.patch < 0)
        {
            kappaf[face.face] = conductance/(face.S*delta[face.face]);
        }
        else
        {
            kappaf.boundaryFieldRef()[face.patch][face.patchFace] +=
                conductance
               /mesh_.magSf().boundaryField()[face.patch][face.patchFace]
               /delta.boundaryField()[face.patch][face.patchFace];
        }

        // Vapour enters the gas, and liquid leaves, at Ts
        scalar toGas = 0, toLiquid = 0;
        for (label i = 0; i < n; i++)
        {
            const scalar N = N_[k*n + i];
            if (N > 0)
            {
                toGas += N*face.S*gas_.CpVapour(i, Ts_[k]);
            }
            else if (N < 0)
            {
                toLiquid -=
                    N*face.S*liquid_.liquids().liquid(i).Cp(p0_, Ts_[k]);
            }
        }

        const scalar V = mesh_.V()[face.gas];
        Su[face.gas] += (KG_[k]*gives + toGas*Ts_[k])/V;
        Sp[face.gas] += (KG_[k]*takes + toGas)/V;

        liquidSu[k] = KL_[k]*gives + toLiquid*Ts_[k];
        liquidSp[k] = KL_[k]*takes + toLiquid;
    }

    scalarField cellSu(mesh_.nCells(), Zero), cellSp(mesh_.nCells(), Zero);
    faces_.toLiquid(liquidSu, cellSu);
    faces_.toLiquid(liquidSp, cellSp);
    Su.field() += cellSu/mesh_.V();
    Sp.field() += cellSp/mesh_.V();

    // The other side of a processor boundary has the conductance, too
    scalarList across(mesh_.nFaces() - mesh_.nInternalFaces(), Zero);
    for (const interfaceFace& face : faces)
    {
        if (face.patch >= 0 && !face.wall)
        {
            across[face.face - mesh_.nInternalFaces()] =
                kappaf.boundaryField()[face.patch][face.patchFace];
        }
    }
    syncTools::swapBoundaryFaceList(mesh_, across);
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.coupled())
        {
            forAll(patch, facei)
            {
                const scalar value =
                    across
                    [
                        patch.start() - mesh_.nInternalFaces() + facei
                    ];
                if (!faces_.gas()[patch.faceCells()[facei]] && value > 0)
                {
                    kappaf.boundaryFieldRef()[patchi][facei] = value;
                }
            }
        }
    }
}


void Foam::dew::interfaceTransfer::heatRates
(
    const volScalarField& T,
    const scalar Tref,
    scalar& latent,
    scalar& gas,
    scalar& liquid
) const
{
    vector rates(Zero);
    forAll(faces_.faces(), k)
    {
        const scalar TG = T[faces_.faces()[k].gas];
        for (label i = 0; i < size(); i++)
        {
            const scalar m = through(k, i);
            if (m != 0)
            {
                const auto& l = liquid_.liquids().liquid(i);
                const scalar TV = m > 0 ? Ts_[k] : TG;
                const scalar TL = m > 0 ? TN_[k] : Ts_[k];
                rates[0] += m*l.hv(p0_, Ts_[k]);
                rates[1] += m*gas_.CpVapour(i, TV)*(TV - Tref);
                rates[2] += m*l.Cp(p0_, TL)*(TL - Tref);
            }
        }
    }
    reduce(rates, sumOp<vector>());
    latent = rates[0];
    gas = rates[1];
    liquid = rates[2];
}


Foam::scalar Foam::dew::interfaceTransfer::wallHeat() const
{
    scalar heat = 0;
    forAll(faces_.faces(), k)
    {
        if (faces_.faces()[k].wall)
        {
            heat += KL_[k]*(TN_[k] - Ts_[k]);
        }
    }
    return returnReduce(heat, sumOp<scalar>());
}


Foam::tmp<Foam::scalarField> Foam::dew::interfaceTransfer::sourceOf
(
    const scalar factor
) const
{
    auto tsource = tmp<scalarField>::New(mesh_.nCells(), Zero);
    scalarField& source = tsource.ref();
    forAll(total_, k)
    {
        const label celli = faces_.faces()[k].gas;
        source[celli] += factor*through(k)/mesh_.V()[celli];
    }
    return tsource;
}


// ************************************************************************* //
