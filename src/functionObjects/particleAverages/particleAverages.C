/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleAverages.H"
#include "addToRunTimeSelectionTable.H"
#include "Time.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(particleAverages);
    addToRunTimeSelectionTable(functionObject, particleAverages, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleAverages::particleAverages
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    functionObjects::regionFunctionObject(name, time, dict),
    timeAverage_(false),
    averageStart_(time.value()),
    last_(time.value()),
    duration_(0)
{
    read(dict);
    if (timeAverage_)
    {
        readMeans();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::fvMesh& Foam::dew::particleAverages::mesh() const
{
    return refCast<const fvMesh>(obr_);
}


const Foam::dew::particleExchange& Foam::dew::particleAverages::exchange() const
{
    return obr_.lookupObject<particleExchange>("particleExchange");
}


void Foam::dew::particleAverages::make
(
    const dictionary& dict,
    const wordList& names
)
{
    const auto one = [&](const word& name, const dimensionSet& dims, auto& to)
    {
        to.clear();
        if (!names.found(name))
        {
            return;
        }
        for (const word& taken : {name, word(name + "Mean")})
        {
            if (obr_.found(taken))
            {
                FatalIOErrorInFunction(dict)
                    << "There is already a field '" << taken << "'" << nl
                    << "Let one function object alone make it"
                    << exit(FatalIOError);
            }
        }
        typedef typename std::decay<decltype(*to)>::type fieldType;
        to.reset(new fieldType(name, dims, mesh(), timeAverage_));
    };

    one("alpha.particles", dimless, alpha_);
    one("bulkDensity.particles", dimDensity, density_);
    one("numberDensity.particles", dimless/dimVolume, number_);
    one("U.particles", dimVelocity, U_);
    one("T.particles", dimTemperature, T_);
    one("granularTemperature", sqr(dimVelocity), granularTemperature_);
    one("kineticStress", dimPressure, kineticStress_);
    one("collisionalStress", dimPressure, collisionalStress_);
    one("contactNumber", dimless, contactNumber_);
}


template<class Op>
void Foam::dew::particleAverages::forAllFields(const Op& op)
{
    const auto one = [&op](auto& field, averagedField<scalar>* weight)
    {
        if (field)
        {
            op(*field, weight);
        }
    };
    one(U_, density_.get());
    one(T_, density_.get());
    one(granularTemperature_, density_.get());
    one(contactNumber_, number_.get());
    one(alpha_, nullptr);
    one(kineticStress_, nullptr);
    one(collisionalStress_, nullptr);

    // Last, as they are the weights of the others
    one(density_, nullptr);
    one(number_, nullptr);
}


void Foam::dew::particleAverages::readMeans()
{
    const scalar t = time_.value();
    const scalar written = getProperty<scalar>("time", -GREAT);
    bool complete = mag(written - t) < 0.5*time_.deltaTValue();

    if (complete)
    {
        forAllFields
        (
            [&](auto& field, averagedField<scalar>*)
            {
                complete = field.meanOnDisk() && complete;
            }
        );
    }
    if (!complete)
    {
        if (time_.timeIndex() > 0 && t >= averageStart_)
        {
            Info<< name() << ": the means start anew at time " << t
                << ", they were not written here" << nl << endl;
        }
        return;
    }
    forAllFields([](auto& f, averagedField<scalar>*) { f.readMean(); });
    duration_ = getProperty<scalar>("duration");
}


void Foam::dew::particleAverages::addToMeans(const scalar dt)
{
    // A weight that is the same in all cells
    struct uniform
    {
        scalar value;
        scalar operator[](const label) const { return value; }
    };

    forAllFields
    (
        [&](auto& field, averagedField<scalar>* weight)
        {
            if (weight)
            {
                field.addToMean
                (
                    scalarField(duration_*weight->meanCells()),
                    scalarField(dt*weight->cells())
                );
            }
            else
            {
                field.addToMean(uniform{duration_}, uniform{dt});
            }
        }
    );
    duration_ += dt;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::particleAverages::read(const dictionary& dict)
{
    regionFunctionObject::read(dict);

    if (!obr_.foundObject<particleExchange>("particleExchange"))
    {
        // A plain error would only be a warning here
        FatalIOErrorInFunction(dict)
            << "Function object " << name() << " of type " << typeName
            << " needs the map between particles and cells that solvers with"
            << " a fluid have" << nl << "Use it with cfdDemFoam; for particles"
            << " alone with 'momentum none;' and 'forces {}' in the coupling"
            << exit(FatalIOError);
    }

    wordList names
    {
        "alpha.particles", "bulkDensity.particles", "numberDensity.particles",
        "U.particles", "T.particles", "granularTemperature", "kineticStress",
        "collisionalStress", "contactNumber"
    };
    wordList wanted(dict.get<wordList>("fields"));
    for (const word& name : wanted)
    {
        if (!names.found(name))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown field '" << name << "'" << nl << "Fields are "
                << flatOutput(names) << exit(FatalIOError);
        }
    }
    if (wanted.found("T.particles") && !particles().thermal)
    {
        FatalIOErrorInFunction(dict)
            << "Field 'T.particles' needs particles with a temperature" << nl
            << "Add 'heat on;' to constant/particleProperties, or remove the"
            << " field" << exit(FatalIOError);
    }

    timeAverage_ = dict.getOrDefault<Switch>("timeAverage", false);
    if (dict.found("averageStart"))
    {
        averageStart_ = userEntry::number(dict, "averageStart", dimTime);
    }
    userEntry::onlyThese
    (
        dict,
        seriesFile::entries({"fields", "timeAverage", "averageStart"})
    );

    // Weights
    if (timeAverage_)
    {
        if
        (
            wanted.found("U.particles") || wanted.found("T.particles")
         || wanted.found("granularTemperature")
        )
        {
            wanted.append("bulkDensity.particles");
        }
        if (wanted.found("contactNumber"))
        {
            wanted.append("numberDensity.particles");
        }
    }
    make(dict, wanted);
    duration_ = 0;

    return true;
}


bool Foam::dew::particleAverages::write()
{
    forAllFields([](auto& f, averagedField<scalar>*) { f.write(); });

    if (timeAverage_)
    {
        setProperty("time", time_.value());
        setProperty("duration", duration_);
    }
    return true;
}
