/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantPotential.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace colloidLaws
{
    defineTypeName(constantPotential);
    addToRunTimeSelectionTable(colloidLaw, constantPotential, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaws::constantPotential::constantPotential
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

Foam::dew::colloidForce Foam::dew::colloidLaws::constantPotential::law
(
    double h, double Rd, double psi1, double psi2
) const
{
    return layer_.constantPotential(h, Rd, psi1, psi2);
}
