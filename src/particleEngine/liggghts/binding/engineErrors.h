/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Header
    engineErrors

Description
    The engine's errors as C++ exceptions (std::runtime_error with the
    engine's own words) and its warnings as a list.

SourceFiles
    engineErrors.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_engineErrors_h
#define dew_engineErrors_h

#include <mpi.h>
#include <string>
#include <vector>

namespace Foam
{
namespace dew
{

//- Warnings on this rank since the last call
std::vector<std::string> engineWarnings();

} // End namespace dew
} // End namespace Foam

#endif
