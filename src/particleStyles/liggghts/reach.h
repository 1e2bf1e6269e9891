/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Header
    reach

Description
    The address of a member of the engine that its header keeps private. Access
    checks do not apply to the arguments of an explicit instantiation
    ([temp.explicit] 12), which is used here to reach it without changing any
    layout or symbol.

    \verbatim
    struct mapTag
    {
        typedef Map* Owner::*type;
        friend type address(mapTag);
    };
    template struct reach<mapTag, &Owner::map_>;

    Map* m = owner.*address(mapTag());
    \endverbatim
\*---------------------------------------------------------------------------*/

#ifndef dew_reach_h
#define dew_reach_h

namespace Foam
{
namespace dew
{

template<class Tag, typename Tag::type member>
struct reach
{
    friend typename Tag::type address(Tag) { return member; }
};

} // End namespace dew
} // End namespace Foam

#endif
