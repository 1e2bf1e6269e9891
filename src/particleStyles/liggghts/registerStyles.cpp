/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "registerStyles.h"
#include "fixColloidPairs.h"
#include "fixConduction.h"
#include "fixDissipativePairs.h"
#include "fixGravity.h"
#include "fixImmersion.h"
#include "fixIntegrate.h"
#include "fixListReach.h"
#include "fixLubrication.h"
#include "fixWallContacts.h"
#include "reach.h"

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
    fixes["dew/wallContacts"] = &makeFix<fixWallContacts>;
    fixes["dew/listReach"] = &makeFix<fixListReach>;
    fixes["dew/lubrication"] = &makeFix<fixLubrication>;
    fixes["dew/colloidPairs"] = &makeFix<fixColloidPairs>;
    fixes["dew/dissipativePairs"] = &makeFix<fixDissipativePairs>;
    fixes["dew/immersion"] = &makeFix<fixImmersion>;
    fixes["dew/conduction"] = &makeFix<fixConduction>;
}
