/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// The fluid's velocity at walls, as the particles in the cells there see it

#include "particleExchange.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

//- One over the square of the layer's thickness [1/m2], of the void fraction
//  and the sum of 3 pi d in unit volume [1/m2]
scalar perLayer2(const scalar eps, const scalar stokes)
{
    const scalar phi = Foam::max(1 - eps, scalar(0));

    // Drag at small Re over that of one sphere
    const scalar drag =
        10*phi/eps + Foam::pow3(eps)*(1 + 1.5*Foam::sqrt(phi));

    return stokes*drag/eps;
}


//- Slope half way to a wall at distance x, over that of the line to it
scalar slope(const scalar x)
{
    const scalar half = 0.5*Foam::min(x, scalar(100));
    return half > 1e-6 ? half/std::sinh(half) : 1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::volVectorField>
Foam::dew::particleExchange::velocityWithWallLayers() const
{
    tmp<volVectorField> tU(new volVectorField("USeen", fluid_.Uc));

    // Where the fluid sticks; the same patches on all ranks
    DynamicList<label> walls;
    forAll(mesh_.boundary(), patchi)
    {
        if
        (
            isA<wallFvPatch>(mesh_.boundary()[patchi])
         && fluid_.U.boundaryField()[patchi].fixesValue()
        )
        {
            walls.append(patchi);
        }
    }

    // A fluid that does not feel the particles has its own layer
    if (!twoWay() || walls.empty())
    {
        return tU;
    }

    struct resistance
    {
        scalar R;
        vector Rv;
    };
    List<resistance> values(state_.size());
    forAll(values, i)
    {
        const scalar R = 3*constant::mathematical::pi*state_.d[i];
        values[i] = resistance{R, R*map_.toMesh(state_.v[i], i)};
    }

    scalarField R(mesh_.nCells(), Zero);
    vectorField Rv(mesh_.nCells(), Zero);
    map_.share
    (
        values,
        [&](const label celli, const scalar w, const resistance& value)
        {
            R[celli] += w*value.R;
            Rv[celli] += w*value.Rv;
        }
    );
    smoothing_->spread(R);
    smoothing_->spread(Rv);

    const scalarField& V = mesh_.V();
    const scalarField& alphac = alphac_.field();
    volVectorField& U = tU.ref();

    for (const label patchi : walls)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const labelUList& cells = patch.faceCells();
        const vectorField n(patch.nf());
        const scalarField& perDistance = patch.deltaCoeffs();
        vectorField& Uw = U.boundaryFieldRef()[patchi];

        forAll(cells, facei)
        {
            const label c = cells[facei];
            if (R[c] > 0)
            {
                const vector slip(U[c] - Rv[c]/R[c]);
                const scalar x =
                    std::sqrt(perLayer2(alphac[c], R[c]/V[c]))
                   /perDistance[facei];

                Uw[facei] +=
                    (1 - slope(x))*(slip - (slip & n[facei])*n[facei]);
            }
        }
    }

    return tU;
}


// ************************************************************************* //
