/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleList.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleList::clear()
{
    type.clear();
    x.clear();
    v.clear();
    omega.clear();
    d.clear();
    T.clear();
}


void Foam::dew::particleList::append
(
    const label typei,
    const point& xi,
    const vector& vi,
    const vector& omegai,
    const scalar di,
    const scalar Ti
)
{
    type.append(typei);
    x.append(xi);
    v.append(vi);
    omega.append(omegai);
    d.append(di);
    T.append(Ti);
}


void Foam::dew::particleList::scatter()
{
    Pstream::scatter(type);
    Pstream::scatter(x);
    Pstream::scatter(v);
    Pstream::scatter(omega);
    Pstream::scatter(d);
    Pstream::scatter(T);
}


void Foam::dew::particleList::subset(const UList<bool>& keep)
{
    label n = 0;
    forAll(keep, i)
    {
        if (keep[i])
        {
            type[n] = type[i];
            x[n] = x[i];
            v[n] = v[i];
            omega[n] = omega[i];
            d[n] = d[i];
            T[n] = T[i];
            n++;
        }
    }

    type.setSize(n);
    x.setSize(n);
    v.setSize(n);
    omega.setSize(n);
    d.setSize(n);
    T.setSize(n);
}
