/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantGasMixture.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace gasMixtures
{
    defineTypeName(constantGasMixture);
    addToRunTimeSelectionTable(gasMixture, constantGasMixture, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- One number, or one for each vapour
scalarField diffusivities(const dictionary& dict, const label n)
{
    ITstream& is = dict.lookup("D");
    const token first(is);
    is.rewind();
    if (!first.isPunctuation() || first.pToken() != token::BEGIN_LIST)
    {
        return scalarField
        (
            n, dew::userEntry::positive(dict, "D", dimViscosity)
        );
    }

    const scalarList D(is);
    if (D.size() != n || !(n && min(D) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Diffusivities D " << D << " of " << n << " vapours" << nl
            << "Give one positive number, or as many as there are vapours"
            << exit(FatalIOError);
    }
    return scalarField(D);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::gasMixtures::constantGasMixture::constantGasMixture
(
    const dictionary& dict,
    const liquidMixture& liquids
)
:
    gasMixture
    (
        userEntry::positive(dict, "p0", dimPressure),
        liquids,
        1e-3*userEntry::within(dict, "Wc", 1, 2000)
    ),
    rho_(userEntry::positive(dict, "rho", dimDensity)),
    D_(diffusivities(dict, liquids.size())),
    Cp_(userEntry::positive(dict, "Cp", dimSpecificHeatCapacity)),
    CpVapour_
    (
        userEntry::positiveOr(dict, "CpVapour", dimSpecificHeatCapacity, Cp_)
    ),
    kappa_
    (
        userEntry::positive
        (
            dict, "kappa", dimPower/dimLength/dimTemperature
        )
    ),
    mu_(userEntry::positive(dict, "mu", dimDynamicViscosity))
{
    userEntry::onlyThese
    (
        dict,
        {"type", "p0", "Wc", "rho", "D", "Cp", "CpVapour", "kappa", "mu"}
    );
}
