/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heatTransferModel.H"
#include "lawQuantities.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(heatTransferModel, 0);
    defineRunTimeSelectionTable(heatTransferModel, dictionary);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::heatTransferModel::Qp
(
    const particle& p,
    const carrier& c
) const
{
    const scalar Re = lawQuantities::ReSingle(p, c);
    const scalar Pr = c.mu*c.Cp/c.kappa;

    return Nu(Re, Pr, c.alphac)*c.kappa*constant::mathematical::pi*p.d;
}
