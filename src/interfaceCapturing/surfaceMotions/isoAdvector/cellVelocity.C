/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellVelocity.H"
#include "emptyFvPatch.H"
#include "wedgeFvPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::cellVelocity::cellVelocity(const volVectorField& U)
:
    U_(U),
    mesh_(U.mesh()),
    across_(mesh_.boundary().size()),
    delta_(mesh_.boundary().size())
{
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const fvPatchVectorField& Ub = U.boundaryField()[patchi];
        if (isA<emptyFvPatch>(patch) || isA<wedgeFvPatch>(patch))
        {
            continue;
        }
        if (patch.coupled())
        {
            across_[patchi] = Ub.patchNeighbourField();
            delta_[patchi] = patch.delta();
        }
        else
        {
            across_[patchi] = Ub;
            delta_[patchi] = patch.Cf() - patch.Cn();
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::cellVelocity::operator()
(
    const label celli,
    const point& x,
    const vector& n
) const
{
    const vectorField& centres = mesh_.cellCentres();
    const Vector<label>& directions = mesh_.geometricD();
    const vector& Uc = U_[celli];

    symmTensor M(Zero);
    vector b(Zero);
    for (const label facei : mesh_.cells()[celli])
    {
        vector d, dU;
        if (mesh_.isInternalFace(facei))
        {
            const label own = mesh_.faceOwner()[facei];
            const label other =
                own == celli ? mesh_.faceNeighbour()[facei] : own;
            d = centres[other] - centres[celli];
            dU = U_[other] - Uc;
        }
        else
        {
            const label patchi =
                mesh_.boundaryMesh().patchID()[facei - mesh_.nInternalFaces()];
            const label i = facei - mesh_.boundaryMesh()[patchi].start();
            if (across_[patchi].empty())
            {
                continue;
            }
            d = delta_[patchi][i];
            dU = across_[patchi][i] - Uc;
        }

        for (direction k = 0; k < vector::nComponents; k++)
        {
            d[k] = directions[k] < 0 ? 0 : d[k];
        }
        const scalar weight = 1/magSqr(d);
        M += weight*sqr(d);
        b += weight*d*(dU & n);
    }

    // Nothing varies along the other directions
    const symmTensor unit
    (
        directions.x() < 0, 0, 0, directions.y() < 0, 0, directions.z() < 0
    );

    return (Uc & n) + ((inv(M + unit) & b) & (x - centres[celli]));
}
