/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liggghtsLibrary.H"
#include "error.H"

#include <dlfcn.h>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liggghtsLibrary::liggghtsLibrary
(
    const dictionary& dict,
    const liggghtsOptions& options
)
:
    handle_(nullptr)
{
    const fileName name
    (
        dict.getOrDefault<fileName>("library", "libdewLiggghts.so")
    );

    handle_ = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);

    if (!handle_)
    {
        FatalIOErrorInFunction(dict)
            << "Cannot load the particle engine: " << ::dlerror() << nl
            << "Install LIGGGHTS 3.8 (etc/setup), build (Allwmake) and source"
            << " etc/bashrc; entry 'library' is " << name
            << exit(FatalIOError);
    }

    typedef int (*versionFunction)();
    typedef liggghtsBinding* (*newFunction)
    (
        const liggghtsOptions*, const char**
    );

    const versionFunction version = reinterpret_cast<versionFunction>
    (
        ::dlsym(handle_, "dewLiggghtsBindingVersion")
    );
    const newFunction make = reinterpret_cast<newFunction>
    (
        ::dlsym(handle_, "dewLiggghtsNew")
    );

    if (!version || !make || version() != liggghtsBindingVersion)
    {
        FatalIOErrorInFunction(dict)
            << "The library " << name << " is not the particle engine of this"
            << " program (interface version "
            << (version ? version() : 0) << ", expected "
            << liggghtsBindingVersion << ')' << nl
            << "Rebuild with Allwmake, or correct the entry 'library'"
            << exit(FatalIOError);
    }

    const char* error = nullptr;
    engine_.reset(make(&options, &error));

    if (!engine_)
    {
        fail("starting the engine", error);
    }

    const std::string found(engine_->version());
    if
    (
        found.find("LIGGGHTS") == std::string::npos
     || found.find("3.8") == std::string::npos
    )
    {
        FatalIOErrorInFunction(dict)
            << "The engine reports itself as '" << found.c_str()
            << "'; LIGGGHTS 3.8 is needed" << nl
            << "Install Debian's package liggghts 3.8.0 (etc/setup)"
            << exit(FatalIOError);
    }
}


Foam::dew::liggghtsLibrary::~liggghtsLibrary()
{
    engine_.reset();

    // Left open: the engine's static objects are destroyed with the process
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::liggghtsLibrary::fail
(
    const std::string& doing,
    const char* what
) const
{
    // Perhaps on this rank alone: no collective call from here on
    FatalErrorInFunction
        << "Particle engine, " << doing.c_str() << ":" << nl
        << "    " << what
        << exit(FatalError);

    ::abort();      // never reached: exit() ends the run
}
