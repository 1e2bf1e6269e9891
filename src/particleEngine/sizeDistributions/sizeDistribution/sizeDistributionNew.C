/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sizeDistribution.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::sizeDistribution>
Foam::dew::sizeDistribution::New(const dictionary& dict)
{
    autoPtr<sizeDistribution> result
    (
        selectVariant<sizeDistribution>(dict, "type", "sizeDistribution")(dict)
    );
    const sizeDistribution& D = result();

    if (D.max() > D.min() && !(D.cumulative(D.max()) > D.cumulative(D.min())))
    {
        FatalIOErrorInFunction(dict)
            << "In " << dict.dictName() << " no diameter of the distribution"
            << " lies between min (" << D.min() << ") and max (" << D.max()
            << ")" << nl << "Move the range or the distribution"
            << exit(FatalIOError);
    }

    return result;
}
