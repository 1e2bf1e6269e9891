/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "boxRegion.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace regions
{
    defineTypeName(boxRegion);
    addToRunTimeSelectionTable(insertionRegion, boxRegion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::regions::boxRegion::boxRegion(const dictionary& dict)
:
    box_
    (
        userEntry::point(dict, "min", dimLength),
        userEntry::point(dict, "max", dimLength)
    )
{
    userEntry::onlyThese(dict, {"type", "min", "max"});

    if (!(cmptMin(box_.span()) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "In " << dict.dictName() << " max " << box_.max()
            << " is not above min " << box_.min() << " in every direction"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::dew::regions::boxRegion::bounds() const
{
    return box_;
}


Foam::scalar Foam::dew::regions::boxRegion::volume() const
{
    return box_.volume();
}


bool Foam::dew::regions::boxRegion::holds(const point& x, const scalar r) const
{
    return
        cmptMin(x - box_.min()) >= r
     && cmptMin(box_.max() - x) >= r;
}
