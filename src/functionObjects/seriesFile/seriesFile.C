/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "seriesFile.H"
#include "functionObject.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::seriesFile::line
(
    const Time& time,
    const word& functionObjectName,
    const string& columns,
    const UList<scalar>& values
)
{
    if (!stream_)
    {
        const fileName folder
        (
            time.globalPath()/"postProcessing"/functionObjectName
           /time.timeName(time.startTime().value())
        );
        mkDir(folder);
        stream_.reset(new OFstream(folder/name_));
        stream_->precision(12);
        *stream_ << "# time [s], " << columns.c_str() << endl;
    }

    *stream_ << time.value();
    for (const scalar value : values)
    {
        *stream_ << ' ' << value;
    }
    *stream_ << endl;
}


const Foam::dew::particleEngine& Foam::dew::seriesFile::particles
(
    const objectRegistry& obr,
    const functionObject& object
)
{
    const particleEngine* engine = obr.cfindObject<particleEngine>("particles");
    if (!engine)
    {
        FatalErrorInFunction
            << "Function object " << object.name() << " of type "
            << object.type() << " finds no particles" << nl
            << "Use it with a solver that has them"
            << exit(FatalError);
    }
    return *engine;
}


Foam::wordList Foam::dew::seriesFile::entries
(
    std::initializer_list<word> own
)
{
    wordList all
    {
        "type", "libs", "functionObjectLibs", "region", "subRegion", "enabled",
        "log", "timeStart", "timeEnd", "executeControl", "executeInterval",
        "writeControl", "writeInterval"
    };
    for (const word& name : own)
    {
        all.append(name);
    }
    return all;
}
