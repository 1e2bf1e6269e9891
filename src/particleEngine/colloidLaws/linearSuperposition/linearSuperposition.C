/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "linearSuperposition.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace colloidLaws
{
    defineTypeName(linearSuperposition);
    addToRunTimeSelectionTable(colloidLaw, linearSuperposition, dictionary);
    addNamedToRunTimeSelectionTable
    (
        colloidLaw, linearSuperposition, dictionary, Yukawa
    );
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaws::linearSuperposition::linearSuperposition
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
:
    doubleLayerLaw(dict, medium, mats),
    eps_(medium.eps()),
    phiT_(medium.phiT()),
    kappa_(medium.kappa())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dew::colloidForce Foam::dew::colloidLaws::linearSuperposition::law
(
    double h, double Rd, double psi1, double psi2
) const
{
    return exponentialForce
    (
        h, superpositionEnergy(Rd, psi1, psi2, eps_, phiT_), kappa_
    );
}
