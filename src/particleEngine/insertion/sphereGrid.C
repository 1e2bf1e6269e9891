/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereGrid.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::sphereGrid::sphereGrid(const particleBox& box, const scalar rMax)
:
    box_(box),
    width_(2*rMax*vector::one),
    n_(label(0))
{
    for (direction k = 0; k < 3; k++)
    {
        if (box.periodic(k))
        {
            const scalar span = box.bounds().span()[k];
            n_[k] = max(label(span/(2*rMax)), label(1));
            width_[k] = span/n_[k];
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::FixedList<Foam::label, 3> Foam::dew::sphereGrid::cell
(
    const point& p
) const
{
    FixedList<label, 3> c;
    for (direction k = 0; k < 3; k++)
    {
        c[k] = label(std::floor((p[k] - box_.bounds().min()[k])/width_[k]));
    }
    return c;
}


long Foam::dew::sphereGrid::key
(
    const label i,
    const label j,
    const label k
) const
{
    const auto wrap = [this](const label c, const direction axis)
    {
        const label n = n_[axis];
        return long(n ? ((c % n) + n) % n : c) & 0x1FFFFF;
    };

    return (wrap(i, 0) << 42) | (wrap(j, 1) << 21) | wrap(k, 2);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::sphereGrid::append(const point& x, const scalar r)
{
    const FixedList<label, 3> c(cell(x));
    cells_[key(c[0], c[1], c[2])].push_back(x_.size());
    x_.append(x);
    r_.append(r);
}


Foam::label Foam::dew::sphereGrid::overlapping
(
    const point& x,
    const scalar r,
    const scalar share
) const
{
    const FixedList<label, 3> c(cell(x));

    for (label s = 0; s < 27; s++)
    {
        const auto found = cells_.find
        (
            key(c[0] + s%3 - 1, c[1] + (s/3)%3 - 1, c[2] + s/9 - 1)
        );

        if (found == cells_.end())
        {
            continue;
        }

        for (const label i : found->second)
        {
            const scalar gap = mag(box_.separation(x, x_[i])) - r - r_[i];
            if (gap < -share*min(r, r_[i]))
            {
                return i;
            }
        }
    }

    return -1;
}
