/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "MULESSurface.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcFlux.H"
#include "MULES.H"
#include "oneField.H"
#include "userEntry.H"
#include "zeroField.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceMotions
{
    defineTypeName(MULESSurface);
    addToRunTimeSelectionTable(surfaceMotion, MULESSurface, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceMotions::MULESSurface::MULESSurface
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
:
    transportedSurface(mesh, surfaceProperties),
    cAlpha_(userEntry::notNegativeOr(dict_, "cAlpha", dimless, 1)),
    nCorrectors_
    (
        dict_.found("nCorrectors") ? userEntry::count(dict_, "nCorrectors") : 2
    )
{
    userEntry::onlyThese(dict_, {"type", "cAlpha", "nCorrectors"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::surfaceMotions::MULESSurface::advect
(
    const surfaceScalarField& alphacPhi,
    const volVectorField&,
    const volScalarField& alphac
)
{
    surfaceScalarField phic(cAlpha_*mag(alphacPhi/mesh_.magSf()));
    for (fvsPatchScalarField& patch : phic.boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch == 0;
        }
    }

    for (label corrector = 0; corrector < nCorrectors_; corrector++)
    {
        const surfaceScalarField phir(-phic*normalFlux());

        alphaPhi_ =
            fvc::flux(alphacPhi, alpha_, "div(phi,alpha)")
          + fvc::flux
            (
               -fvc::flux(-phir, scalar(1) - alpha_, "div(phirb,alpha)"),
                alpha_,
                "div(phirb,alpha)"
            );

        MULES::explicitSolve
        (
            alphac, alpha_, alphacPhi, alphaPhi_, zeroField(), zeroField(),
            oneField(), zeroField()
        );
    }
}
