/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "lawNeeds.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::lawNeeds::refuse
(
    const word& law,
    const dictionary& dict,
    const lawNeeds& offered
) const
{
    if (T && !offered.T)
    {
        FatalIOErrorInFunction(dict)
            << "Law " << law << " needs a temperature, and the fluid has none: "
            << dict.name() << nl
            << "Add the entry 'T', e.g. T 298.15; or a field T to the start"
            << " time" << exit(FatalIOError);
    }
    if (surface && !offered.surface)
    {
        FatalIOErrorInFunction(dict)
            << "Law " << law << " needs a solver with a liquid surface: "
            << dict.name() << nl
            << "Use interDemFoam or interEvapDemFoam, or remove the law"
            << exit(FatalIOError);
    }
    if (tension && !offered.tension)
    {
        FatalIOErrorInFunction(dict)
            << "Law " << law << " needs the surface tension of two fluids, which"
            << " this solver does not offer: " << dict.name() << nl
            << "Use interDemFoam, or remove the law" << exit(FatalIOError);
    }
    if (turbulence && !offered.turbulence)
    {
        FatalIOErrorInFunction(dict)
            << "Law " << law << " needs k and epsilon of a turbulence model, and"
            << " there is none: " << dict.name() << nl
            << "Use cfdDemFoam with simulationType RAS in"
            << " constant/turbulenceProperties, or remove the law"
            << exit(FatalIOError);
    }
    if ((DUDt && !offered.DUDt) || (divTau && !offered.divTau))
    {
        FatalIOErrorInFunction(dict)
            << "Law " << law << " needs the acceleration or the viscous stress"
            << " of the fluid, which this solver does not offer: "
            << dict.name() << nl
            << "Use cfdDemFoam, or remove the law" << exit(FatalIOError);
    }
}
