/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "speciesFields.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::speciesFields::speciesFields(const scalarField& standard)
:
    standard_(standard),
    at_(standard)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::speciesFields::read
(
    const fvMesh& mesh,
    const wordList& names,
    const string& why
)
{
    fields_.setSize(names.size());
    forAll(names, i)
    {
        IOobject io
        (
            names[i], mesh.time().timeName(), mesh, IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        );
        if (!io.typeHeaderOk<volScalarField>(true))
        {
            FatalErrorInFunction
                << "There is no field " << names[i] << " in "
                << mesh.time().timePath() << ": " << why.c_str()
                << exit(FatalError);
        }
        Info<< "Reading " << names[i] << endl;
        fields_.set(i, new volScalarField(io, mesh));

        const scalar least = gMin(fields_[i].primitiveField());
        const scalar most = gMax(fields_[i].primitiveField());
        if (!(least > -1e-6 && most < 1 + 1e-6))
        {
            FatalErrorInFunction
                << "Mass fractions " << names[i] << " in "
                << mesh.time().timePath() << " are from " << least << " to "
                << most << nl << "They must be between 0 and 1"
                << exit(FatalError);
        }
    }
}


// ************************************************************************* //
