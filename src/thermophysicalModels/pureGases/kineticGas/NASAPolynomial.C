/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "NASAPolynomial.H"
#include "DynamicList.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const Foam::dew::NASAPolynomial table[] =
{
    {"He", {2.5, 0, 0, 0, 0}, {2.5, 0, 0, 0, 0}},
    {
        "Ar",
        {2.5, 0, 0, 0, 0},
        {2.5, 0, 0, 0, 0}
    },
    {
        "H2",
        {2.34433112, 0.00798052075, -1.9478151e-05, 2.01572094e-08, -7.37611761e-12},
        {2.93286575, 0.000826608026, -1.46402364e-07, 1.54100414e-11, -6.888048e-16}
    },
    {
        "N2",
        {3.53100528, -0.000123660988, -5.02999433e-07, 2.43530612e-09, -1.40881235e-12},
        {2.95257637, 0.0013969004, -4.92631603e-07, 7.86010195e-11, -4.60755204e-15}
    },
    {
        "O2",
        {3.78245636, -0.00299673416, 9.84730201e-06, -9.68129509e-09, 3.24372837e-12},
        {3.66096065, 0.000656365811, -1.41149627e-07, 2.05797935e-11, -1.29913436e-15}
    },
    {
        "CO",
        {3.5795335, -0.00061035369, 1.0168143e-06, 9.0700586e-10, -9.0442449e-13},
        {3.0484859, 0.0013517281, -4.8579405e-07, 7.8853644e-11, -4.6980746e-15}
    },
    {
        "CO2",
        {2.356813, 0.0089841299, -7.1220632e-06, 2.4573008e-09, -1.4288548e-13},
        {4.6365111, 0.0027414569, -9.9589759e-07, 1.6038666e-10, -9.1619857e-15}
    },
    {
        "CH4",
        {5.14825732, -0.013700241, 4.93749414e-05, -4.91952339e-08, 1.70097299e-11},
        {1.911786, 0.0096026796, -3.38387841e-06, 5.3879724e-10, -3.19306807e-14}
    },
    {
        "H2O",
        {4.1986352, -0.0020364017, 6.5203416e-06, -5.4879269e-09, 1.771968e-12},
        {2.6770389, 0.0029731816, -7.7376889e-07, 9.4433514e-11, -4.2689991e-15}
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

const Foam::dew::NASAPolynomial&
Foam::dew::NASAPolynomial::get(const word& name)
{
    const NASAPolynomial* found = nullptr;
    for (const NASAPolynomial& gas : table)
    {
        if (name == gas.name)
        {
            found = &gas;
        }
    }
    if (!found)
    {
        FatalErrorInFunction
            << "No heat capacity is known of the gas " << name << nl
            << "Known gases: " << names() << exit(FatalError);
    }
    return *found;
}


Foam::wordList Foam::dew::NASAPolynomial::names()
{
    DynamicList<word> names;
    for (const NASAPolynomial& gas : table)
    {
        names.append(gas.name);
    }
    return wordList(std::move(names));
}
