/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// The engine ends the process on any error. These definitions come before its
// own in the symbol order of a library loaded with RTLD_LOCAL, and throw
// instead, so that the solver can end the run with the engine's message.

#include "engineErrors.h"

#include <stdexcept>

#include "compute.h"
#include "error.h"
#include "fix.h"

namespace
{
    std::vector<std::string> warnings_;

    [[noreturn]] void raise(const std::string& text)
    {
        throw std::runtime_error(text);
    }

    std::string detail(const char* kind, const char* style, const char* id)
    {
        return std::string(kind) + ' ' + style + " (id " + id + "): ";
    }

    std::string reason(const char* text)
    {
        return
            std::string(text).size() > 2
          ? std::string(text)
          : std::string("illegal arguments");
    }
}


std::vector<std::string> Foam::dew::engineWarnings()
{
    std::vector<std::string> result;
    result.swap(warnings_);
    return result;
}


namespace LAMMPS_NS
{

void Error::all(const char*, int, const char* text)
{
    raise(text);
}

void Error::one(const char*, int, const char* text)
{
    raise(text);
}

void Error::universe_all(const char*, int, const char* text)
{
    raise(text);
}

void Error::universe_one(const char*, int, const char* text)
{
    raise(text);
}

void Error::fix_error(const char* f, int l, Fix* fix, const char* text)
{
    fix_error(f, l, fix, fix->style, text);
}

void Error::fix_error
(
    const char*, int, Fix* fix, const char* style, const char* text
)
{
    raise(detail("fix", style, fix->id) + reason(text));
}

void Error::compute_error(const char*, int, Compute* compute, const char* text)
{
    raise(detail("compute", compute->style, compute->id) + reason(text));
}

void Error::done()
{
    raise("the command quit ends the engine; remove it");
}

void Error::warning(const char*, int, const char* text, int)
{
    warnings_.push_back(text);
}

void Error::warningAll(const char*, int, const char* text, int)
{
    warnings_.push_back(text);
}

} // End namespace LAMMPS_NS
