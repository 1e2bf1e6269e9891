/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "farFieldFvPatchScalarField.H"
#include "addToRunTimeSelectionTable.H"
#include "fvPatchFieldMapper.H"
#include "surfaceFields.H"
#include "userEntry.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    makePatchTypeField(fvPatchScalarField, farFieldFvPatchScalarField);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::farFieldFvPatchScalarField::updateFraction()
{
    const vectorField r(patch().Cf() - origin_);
    const scalarField h((r & patch().nf())/magSqr(r));

    forAll(h, facei)
    {
        // Also not a number
        if (!(h[facei] > 0))
        {
            FatalErrorInFunction
                << "farField of " << internalField().name() << " on patch "
                << patch().name() << ": the face at " << patch().Cf()[facei]
                << " does not face away from the origin " << origin_ << nl
                << "Put origin inside the domain; a plane through it is a"
                << " symmetry plane: use zeroGradient there"
                << exit(FatalError);
        }
    }

    valueFraction() = h/(h + patch().deltaCoeffs());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::farFieldFvPatchScalarField::farFieldFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    mixedFvPatchScalarField(p, iF),
    origin_(Zero)
{
    refValue() = 0;
    refGrad() = 0;
    valueFraction() = 0;
}


Foam::dew::farFieldFvPatchScalarField::farFieldFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    mixedFvPatchScalarField(p, iF),
    origin_(userEntry::pointOr(dict, "origin", dimLength, Zero))
{
    refValue() = scalarField("infinity", dict, p.size());
    refGrad() = 0;
    valueFraction() = 0;

    if (dict.found("value"))
    {
        fvPatchScalarField::operator=
        (
            scalarField("value", dict, p.size())
        );
    }
    else
    {
        fvPatchScalarField::operator=(refValue());
    }
}


Foam::dew::farFieldFvPatchScalarField::farFieldFvPatchScalarField
(
    const farFieldFvPatchScalarField& other,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    mixedFvPatchScalarField(other, p, iF, mapper),
    origin_(other.origin_)
{}


Foam::dew::farFieldFvPatchScalarField::farFieldFvPatchScalarField
(
    const farFieldFvPatchScalarField& other
)
:
    mixedFvPatchScalarField(other),
    origin_(other.origin_)
{}


Foam::dew::farFieldFvPatchScalarField::farFieldFvPatchScalarField
(
    const farFieldFvPatchScalarField& other,
    const DimensionedField<scalar, volMesh>& iF
)
:
    mixedFvPatchScalarField(other, iF),
    origin_(other.origin_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::farFieldFvPatchScalarField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    updateFraction();
    mixedFvPatchScalarField::updateCoeffs();
}


void Foam::dew::farFieldFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    refValue().writeEntry("infinity", os);
    os.writeEntry("origin", origin_);
    writeEntry("value", os);
}
