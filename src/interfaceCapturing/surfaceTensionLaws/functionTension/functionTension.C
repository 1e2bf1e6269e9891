/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "functionTension.H"
#include "addToRunTimeSelectionTable.H"
#include "TableBase.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceTensionLaws
{
    defineTypeName(functionTension);
    addToRunTimeSelectionTable(surfaceTensionLaw, functionTension, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceTensionLaws::functionTension::functionTension
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    surfaceTensionLaw(mesh, dict),
    sigma_(Function1<scalar>::New("sigma", dict)),
    range_(surfaceTensionLaw::range())
{
    userEntry::onlyThese(dict, {"type", "field", "sigma", "sigmaCoeffs"});

    if (isA<Function1Types::TableBase<scalar>>(sigma_()))
    {
        const scalarField X
        (
            refCast<Function1Types::TableBase<scalar>>(sigma_()).x()
        );
        range_ = scalarMinMax(X.first(), X.last());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::surfaceTensionLaws::functionTension::slope
(
    const scalar X
) const
{
    const bool table = range_.max() < VGREAT;
    const scalar d =
        1e-4*(table ? range_.mag() : max(mag(X), SMALL));
    const scalar low = max(X - d, range_.min());
    const scalar high = min(X + d, range_.max());

    return (sigma_->value(high) - sigma_->value(low))/(high - low);
}
