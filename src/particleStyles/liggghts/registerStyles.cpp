/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "registerStyles.h"
#include "fixGravity.h"
#include "fixIntegrate.h"

#include <map>
#include <string>

#include "lammps.h"
#include "modify.h"

using namespace LAMMPS_NS;

namespace Foam
{
namespace dew
{

typedef std::map<std::string, Fix* (*)(LAMMPS*, int, char**)> fixMap;

template<class Tag, typename Tag::type member>
struct reach
{
    friend typename Tag::type address(Tag) { return member; }
};

struct fixMapTag
{
    typedef fixMap* Modify::*type;
    friend type address(fixMapTag);
};

template struct reach<fixMapTag, &Modify::fix_map>;

template<class Style>
Fix* makeFix(LAMMPS* lmp, int narg, char** arg)
{
    return new Style(lmp, narg, arg);
}

} // End namespace dew
} // End namespace Foam


void Foam::dew::registerStyles(LAMMPS* lmp)
{
    fixMap& fixes = *(lmp->modify->*address(fixMapTag()));

    fixes["dew/integrate"] = &makeFix<fixIntegrate>;
    fixes["dew/gravity"] = &makeFix<fixGravity>;
}
