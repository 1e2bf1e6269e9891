/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "colloidMedium.H"
#include "doubleLayer.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidMedium::colloidMedium(const dictionary& dict)
:
    T_(userEntry::positive(dict, "temperature", dimTemperature)),
    eps_(0),
    kappa_(0),
    phiT_
    (
        thermalPotential
        (
            T_, userEntry::positiveOr(dict, "valence", dimless, 1)
        )
    ),
    minGap_(userEntry::notNegative(dict, "minGap", dimLength)),
    cutOff_(userEntry::positive(dict, "cutOff", dimLength))
{
    userEntry::onlyThese
    (
        dict,
        {
            "temperature", "permittivity", "valence", "ionicStrength",
            "debyeLength", "minGap", "cutOff", "roughness", "forces"
        }
    );

    scalar epsR = 0;
    if (dict.found("permittivity"))
    {
        epsR = userEntry::positive(dict, "permittivity", dimless);
        eps_ = epsR*colloidConstants::vacuum;
    }

    const bool ions = dict.found("ionicStrength");
    if (ions && dict.found("debyeLength"))
    {
        FatalIOErrorInFunction(dict)
            << "Entries 'ionicStrength' and 'debyeLength' in "
            << dict.dictName() << " exclude each other: one follows from the"
            << " other" << nl << "Remove one of them"
            << exit(FatalIOError);
    }
    if (ions && epsR <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'ionicStrength' without 'permittivity' in "
            << dict.dictName() << ": there is no Debye length" << nl
            << "Add permittivity, 78.5 for water"
            << exit(FatalIOError);
    }

    if (ions)
    {
        const scalar I = userEntry::positive
        (
            dict, "ionicStrength", dimMoles/dimVolume
        );
        kappa_ = 1/debyeLength(I, epsR, T_);
    }
    else if (dict.found("debyeLength"))
    {
        kappa_ = 1/userEntry::positive(dict, "debyeLength", dimLength);
    }

    if (minGap_ >= cutOff_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'minGap' in " << dict.dictName() << " is " << minGap_
            << " m, not below cutOff " << cutOff_ << " m" << nl
            << "Lower minGap, 2e-10 to 1e-9 m is usual, or raise cutOff"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::colloidMedium::kT() const
{
    return colloidConstants::boltzmann*T_;
}


void Foam::dew::colloidMedium::needIons(const dictionary& law) const
{
    if (kappa_ <= 0 || eps_ <= 0)
    {
        FatalIOErrorInFunction(law)
            << "Charged surfaces in " << law.dictName() << ", but no "
            << (kappa_ > 0 ? "permittivity" : "ionic strength")
            << " of the liquid" << nl << "Add "
            << (
                   kappa_ > 0
                 ? "permittivity (78.5 for water)"
                 : "ionicStrength [mol/m3] or debyeLength [m]"
               )
            << " to the sub-dictionary colloids"
            << exit(FatalIOError);
    }
}
