/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "doubleLayerLaw.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaws::doubleLayerLaw::doubleLayerLaw
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
:
    colloidLaw(dict, medium, mats, entriesOf::materials)
{
    medium.needIons(dict);

    for (label i = 0; i < mats.size(); i++)
    {
        const dictionary d(ofMaterial(dict, mats, i));
        onlyThese(d, {"zeta", "charge"});

        if (d.found("zeta") == d.found("charge"))
        {
            FatalIOErrorInFunction(d)
                << "Give one of the entries 'zeta' [V] and 'charge' [C/m2] in "
                << d.dictName() << " for material " << mats.names()[i]
                << exit(FatalIOError);
        }

        static const dimensionSet dimVoltage(1, 2, -3, 0, 0, -1, 0);
        static const dimensionSet dimCharge(0, -2, 1, 0, 0, 1, 0);
        psi_.push_back
        (
            d.found("zeta")
          ? userEntry::number(d, "zeta", dimVoltage)
          : GrahamePotential
            (
                userEntry::number(d, "charge", dimCharge),
                medium.kappa(), medium.eps(), medium.phiT()
            )
        );
    }
}
