/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "supportCells.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::supportCells::clear()
{
    start_.clear();
    cell_.clear();
    weight_.clear();
}


void Foam::dew::supportCells::add(const label celli, const scalar weight)
{
    for (label e = start_.last(); e < cell_.size(); e++)
    {
        if (cell_[e] == celli)
        {
            weight_[e] += weight;
            return;
        }
    }
    append(celli, weight);
}


Foam::scalar Foam::dew::supportCells::lastSum() const
{
    scalar sum = 0;
    for (label e = start_.last(); e < cell_.size(); e++)
    {
        sum += weight_[e];
    }
    return sum;
}


void Foam::dew::supportCells::scaleLast(const scalar factor)
{
    for (label e = start_.last(); e < cell_.size(); e++)
    {
        weight_[e] *= factor;
    }
}


void Foam::dew::supportCells::close
(
    DynamicList<portion>& shares,
    DynamicList<particleKey>& guests
)
{
    std::sort(shares.begin(), shares.end());
    guests.clear();
    forAll(shares, i)
    {
        if (i == 0 || !(shares[i].key == shares[i-1].key))
        {
            guests.append(shares[i].key);
            begin();
        }
        add(shares[i].cell, shares[i].weight);
    }
    begin();
}


void Foam::dew::supportCells::scale(const label place, const scalar factor)
{
    for (label e = start_[place]; e < start_[place + 1]; e++)
    {
        weight_[e] *= factor;
    }
}
