/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Header
    registerStyles

Description
    Makes our styles known to an engine at run time; nothing of the engine is
    patched. A new style is one line in registerStyles.cpp.

    Modify::fix_map is private in the engine's header: see reach.h.

SourceFiles
    registerStyles.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_registerStyles_h
#define dew_registerStyles_h

namespace LAMMPS_NS { class LAMMPS; }

namespace Foam
{
namespace dew
{

//- Call once for each engine, and again after its command "clear"
void registerStyles(LAMMPS_NS::LAMMPS*);

} // End namespace dew
} // End namespace Foam

#endif
