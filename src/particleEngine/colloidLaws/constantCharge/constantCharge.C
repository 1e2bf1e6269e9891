/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantCharge.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace colloidLaws
{
    defineTypeName(constantCharge);
    addToRunTimeSelectionTable(colloidLaw, constantCharge, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaws::constantCharge::constantCharge
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
:
    doubleLayerLaw(dict, medium, mats),
    layer_{medium.eps(), medium.kappa(), medium.minGap()}
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dew::colloidForce Foam::dew::colloidLaws::constantCharge::law
(
    double h, double Rd, double psi1, double psi2
) const
{
    return layer_.constantCharge(h, Rd, psi1, psi2);
}
