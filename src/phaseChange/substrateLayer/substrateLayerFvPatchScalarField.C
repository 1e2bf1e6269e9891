/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "substrateLayerFvPatchScalarField.H"
#include "addToRunTimeSelectionTable.H"
#include "Enum.H"
#include "fvPatchFieldMapper.H"
#include "surfaceFields.H"
#include "userEntry.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    makePatchTypeField(fvPatchScalarField, substrateLayerFvPatchScalarField);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::substrateLayerFvPatchScalarField::substrateLayerFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    mixedFvPatchScalarField(p, iF),
    thickness_(1),
    rho_(1),
    Cp_(1),
    kappa_(1),
    Tbelow_(-1),
    timeIndex_(iF.time().timeIndex())
{
    refValue() = 0;
    refGrad() = 0;
    valueFraction() = 1;
}


Foam::dew::substrateLayerFvPatchScalarField::substrateLayerFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    mixedFvPatchScalarField(p, iF),
    thickness_(userEntry::positive(dict, "thickness", dimLength)),
    rho_(userEntry::positive(dict, "rho", dimDensity)),
    Cp_(userEntry::positive(dict, "Cp", dimEnergy/dimMass/dimTemperature)),
    kappa_
    (
        userEntry::positive(dict, "kappa", dimPower/dimLength/dimTemperature)
    ),
    Tbelow_(-1),
    T_(dict.found("nCells") ? userEntry::count(dict, "nCells") : 20),
    timeIndex_(iF.time().timeIndex())
{
    const dictionary& below = userEntry::subDict(dict, "below");
    if (Enum<bool>({{true, "temperature"}, {false, "insulated"}}).get("type", below))
    {
        userEntry::onlyThese(below, {"type", "T"});
        Tbelow_ = userEntry::positive(below, "T", dimTemperature);
    }
    else
    {
        userEntry::onlyThese(below, {"type"});
    }

    const scalarField wall("value", dict, p.size());
    fvPatchScalarField::operator=(wall);
    refValue() = wall;
    refGrad() = 0;
    valueFraction() = 1;

    const scalarField start
    (
        dict.found("Tstart")
      ? scalarField(p.size(), userEntry::positive(dict, "Tstart", dimTemperature))
      : wall
    );
    forAll(T_, i)
    {
        T_[i] =
            dict.found(entry(i)) ? scalarField(entry(i), dict, p.size()) : start;
    }
}


Foam::dew::substrateLayerFvPatchScalarField::substrateLayerFvPatchScalarField
(
    const substrateLayerFvPatchScalarField& other,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    mixedFvPatchScalarField(other, p, iF, mapper),
    thickness_(other.thickness_),
    rho_(other.rho_),
    Cp_(other.Cp_),
    kappa_(other.kappa_),
    Tbelow_(other.Tbelow_),
    T_(other.T_.size()),
    timeIndex_(other.timeIndex_)
{
    forAll(T_, i)
    {
        T_[i] = scalarField(other.T_[i], mapper);
    }
}


Foam::dew::substrateLayerFvPatchScalarField::substrateLayerFvPatchScalarField
(
    const substrateLayerFvPatchScalarField& other,
    const DimensionedField<scalar, volMesh>& iF
)
:
    mixedFvPatchScalarField(other, iF),
    thickness_(other.thickness_),
    rho_(other.rho_),
    Cp_(other.Cp_),
    kappa_(other.kappa_),
    Tbelow_(other.Tbelow_),
    T_(other.T_),
    T0_(other.T0_),
    a_(other.a_),
    b_(other.b_),
    timeIndex_(other.timeIndex_)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::substrateLayerFvPatchScalarField::eliminate()
{
    // From below: conductance to what is above, half a cell at the wall
    const label n = T_.size();
    const scalar inside = kappa_/size();
    const scalar store = rho_*Cp_*size()/db().time().deltaTValue();

    a_.setSize(n);
    b_.setSize(n);
    for (label i = n - 1; i >= 0; i--)
    {
        const scalar above = i == 0 ? 2*inside : inside;
        scalar diagonal = store + above;
        a_[i] = store*T0_[i];
        if (i < n - 1)
        {
            diagonal += inside*(1 - b_[i + 1]);
            a_[i] += inside*a_[i + 1];
        }
        else if (Tbelow_ > 0)
        {
            diagonal += 2*inside;
            a_[i] += 2*inside*Tbelow_;
        }
        a_[i] /= diagonal;
        b_[i] = above/diagonal;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::substrateLayerFvPatchScalarField::autoMap
(
    const fvPatchFieldMapper& mapper
)
{
    mixedFvPatchScalarField::autoMap(mapper);
    for (scalarField& T : T_)
    {
        T.autoMap(mapper);
    }
}


void Foam::dew::substrateLayerFvPatchScalarField::rmap
(
    const fvPatchScalarField& field,
    const labelList& addressing
)
{
    mixedFvPatchScalarField::rmap(field, addressing);

    const auto& other = refCast<const substrateLayerFvPatchScalarField>(field);
    forAll(T_, i)
    {
        T_[i].rmap(other.T_[i], addressing);
    }
}


void Foam::dew::substrateLayerFvPatchScalarField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    const label now = db().time().timeIndex();
    if (db().foundObject<surfaceScalarField>("kappaf"))
    {
        if (now != timeIndex_)
        {
            timeIndex_ = now;
            T0_ = T_;
            eliminate();
        }
        const scalarField fluid
        (
            patch().lookupPatchField<surfaceScalarField, scalar>("kappaf")
           *patch().deltaCoeffs()
        );
        const scalar G = 2*kappa_/size()*(1 - b_[0]);

        refValue() = a_[0]/(1 - b_[0]);
        valueFraction() = G/(G + fluid);
    }
    else if (now != timeIndex_ && a_.empty())
    {
        FatalErrorInFunction
            << "substrateLayer of " << internalField().name() << " on patch "
            << patch().name() << " needs kappaf, the conductivity of the"
            << " fluid, which this solver has not" << nl
            << "Use it for T in interEvapDemFoam with 'energy on;' in"
            << " constant/phaseChangeProperties" << exit(FatalError);
    }
    // Outside the equation of the temperature: as it was there

    mixedFvPatchScalarField::updateCoeffs();
}


void Foam::dew::substrateLayerFvPatchScalarField::evaluate
(
    const Pstream::commsTypes commsType
)
{
    mixedFvPatchScalarField::evaluate(commsType);

    if (a_.size() && timeIndex_ == db().time().timeIndex())
    {
        const scalarField* above = this;
        forAll(T_, i)
        {
            T_[i] = a_[i] + b_[i]*(*above);
            above = &T_[i];
        }
    }
}


void Foam::dew::substrateLayerFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    os.writeEntry("thickness", thickness_);
    os.writeEntry("rho", rho_);
    os.writeEntry("Cp", Cp_);
    os.writeEntry("kappa", kappa_);
    os.beginBlock("below");
    os.writeEntry("type", word(Tbelow_ > 0 ? "temperature" : "insulated"));
    if (Tbelow_ > 0)
    {
        os.writeEntry("T", Tbelow_);
    }
    os.endBlock();
    os.writeEntry("nCells", T_.size());
    forAll(T_, i)
    {
        T_[i].writeEntry(entry(i), os);
    }
    writeEntry("value", os);
}


// ************************************************************************* //
