/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactAngles.H"
#include "fvMesh.H"
#include "userEntry.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactAngles::contactAngles
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
:
    mesh_(mesh),
    models_(mesh.boundary().size()),
    theta_(mesh.boundary().size())
{
    const dictionary& dict =
        userEntry::optionalDict(surfaceProperties, "contactAngles");

    for (const entry& e : dict)
    {
        const labelHashSet patches
        (
            mesh.boundaryMesh().patchSet
            (
                wordRes(1, wordRe(e.keyword())), false, false
            )
        );
        if (patches.empty())
        {
            FatalIOErrorInFunction(dict)
                << "No patch is named " << e.keyword() << " as in contactAngles"
                << nl << "Patches: " << mesh.boundaryMesh().names()
                << exit(FatalIOError);
        }

        for (const label patchi : patches)
        {
            if (!isA<wallFvPatch>(mesh.boundary()[patchi]))
            {
                FatalIOErrorInFunction(dict)
                    << "Patch " << mesh.boundary()[patchi].name()
                    << " in contactAngles is not a wall" << nl
                    << "Give it 'type wall' in constant/polyMesh/boundary, or"
                    << " remove the entry" << exit(FatalIOError);
            }
            models_.set(patchi, contactAngle::New(userEntry::dictOf(dict, e)));
            theta_[patchi].setSize(mesh.boundary()[patchi].size());
            theta_[patchi] = models_[patchi].start();
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::contactAngles::correct
(
    const interfacePlanes& planes,
    const surfaceFlow& flow
)
{
    forAll(models_, patchi)
    {
        if (!has(patchi))
        {
            continue;
        }

        const fvPatch& patch = mesh_.boundary()[patchi];
        const vectorField m(patch.nf());
        const labelUList& cells = patch.faceCells();
        scalarField& theta = theta_[patchi];
        theta.setSize(patch.size(), models_[patchi].start());

        forAll(cells, i)
        {
            const label plane = planes.of(cells[i]);
            if (plane < 0)
            {
                continue;
            }
            const vector& n = planes.n()[plane];
            const scalar cosTheta = max(min(-(n & m[i]), scalar(1)), scalar(-1));

            // Along the wall, out of the liquid
            vector t(n - (n & m[i])*m[i]);
            t /= max(mag(t), SMALL);

            contactLineState state;
            state.angle = Foam::acos(cosTheta);
            state.speed = flow.U[cells[i]] & t;
            state.mu = flow.mu[cells[i]];
            state.sigma = flow.sigma[cells[i]];
            theta[i] = models_[patchi].theta(state);
        }
    }
}


Foam::vector Foam::dew::contactAngles::normal
(
    const label patchi,
    const label facei,
    const vector& given
) const
{
    const fvPatch& patch = mesh_.boundary()[patchi];
    const vector m(patch.Sf()[facei]/patch.magSf()[facei]);
    const vector t(given - (given & m)*m);
    const scalar size = mag(t);

    if (size > SMALL)
    {
        return
            has(patchi)
          ? t/size*Foam::sin(theta_[patchi][facei])
          - m*Foam::cos(theta_[patchi][facei])
          : t/size;
    }
    return has(patchi) ? given : vector::zero;
}


Foam::tmp<Foam::vectorField> Foam::dew::contactAngles::normal
(
    const label patchi,
    const vectorField& given
) const
{
    tmp<vectorField> tn(new vectorField(given.size()));
    forAll(given, facei)
    {
        tn.ref()[facei] = normal(patchi, facei, given[facei]);
    }
    return tn;
}
