/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "UNIFACGroups.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const Foam::dew::UNIFACGroups::group groups[] =
{
    {"CH3", 0, 0.9011, 0.848}, {"CH2", 0, 0.6744, 0.540},
    {"CH", 0, 0.4469, 0.228}, {"C", 0, 0.2195, 0},
    {"CH2=CH", 1, 1.3454, 1.176}, {"CH=CH", 1, 1.1167, 0.867},
    {"CH2=C", 1, 1.1173, 0.988}, {"CH=C", 1, 0.8886, 0.676},
    {"C=C", 1, 0.6605, 0.485},
    {"ACH", 2, 0.5313, 0.400}, {"AC", 2, 0.3652, 0.120},
    {"ACCH3", 3, 1.2663, 0.968}, {"ACCH2", 3, 1.0396, 0.660},
    {"ACCH", 3, 0.8121, 0.348},
    {"OH", 4, 1, 1.2},
    {"CH3OH", 5, 1.4311, 1.432},
    {"H2O", 6, 0.92, 1.4},
    {"CH3CO", 7, 1.6724, 1.488}, {"CH2CO", 7, 1.4457, 1.180},
    {"CH3COO", 8, 1.9031, 1.728}, {"CH2COO", 8, 1.6764, 1.420},
    {"CH3O", 9, 1.1450, 1.088}, {"CH2O", 9, 0.9183, 0.780},
    {"CHO", 9, 0.6908, 0.468},
    {"CH3CN", 10, 1.8701, 1.724}, {"CH2CN", 10, 1.6434, 1.416},
    {"COOH", 11, 1.3013, 1.224}, {"HCOOH", 11, 1.5280, 1.532}
};

// Main groups in the order of the header
const Foam::scalar interaction[12][12] =
{
    {
        0, 86.02, 61.13, 76.5, 986.5, 697.2,
        1318, 476.4, 232.1, 251.5, 597, 663.5
    },
    {
        -35.36, 0, 38.81, 74.15, 524.1, 787.6,
        270.6, 182.6, 37.85, 214.5, 336.9, 318.9
    },
    {
        -11.12, 3.446, 0, 167, 636.1, 637.35,
        903.8, 25.77, 5.994, 32.14, 212.5, 537.4
    },
    {
        -69.7, -113.6, -146.8, 0, 803.2, 603.25,
        5695, -52.1, 5688, 213.1, 6096, 872.3
    },
    {
        156.4, 457, 89.6, 25.82, 0, -137.1,
        353.5, 84, 101.1, 28.06, 6.712, 199
    },
    {
        16.51, -12.52, -50, -44.5, 249.1, 0,
        -181, 23.39, -10.72, -128.6, 53.28, -202
    },
    {
        300, 496.1, 362.3, 377.6, -229.1, 289.6,
        0, -195.4, 72.87, 540.5, 112.6, -14.09
    },
    {
        26.76, 42.92, 140.1, 365.8, 164.5, 108.7,
        472.5, 0, -213.7, -103.6, 481.7, 669.4
    },
    {
        114.8, 132.1, 85.84, -170, 245.4, 249.63,
        200.8, 372.2, 0, -235.7, 494.6, 660.2
    },
    {
        83.36, 26.51, 52.13, 65.69, 237.7, 238.4,
        -314.7, 191.1, 461.3, 0, -18.51, 664.6
    },
    {
        24.82, -40.62, -22.97, -138.4, 185.4, 162.6,
        242.8, -287.5, -266.6, 38.81, 0, 205.27
    },
    {
        315.3, 1264, 62.32, 89.86, -151, 339.8,
        -66.17, -297.8, -256.3, -338.5, 92.07, 0
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions  * * * * * * * * * * * * * * * * //

Foam::label Foam::dew::UNIFACGroups::index
(
    const word& name,
    const dictionary& dict
)
{
    label i = 0;
    for (const group& g : groups)
    {
        if (name == g.name)
        {
            return i;
        }
        i++;
    }
    FatalIOErrorInFunction(dict)
        << "Unknown UNIFAC group " << name << nl
        << "Known groups: " << names() << exit(FatalIOError);
    return -1;
}


const Foam::dew::UNIFACGroups::group&
Foam::dew::UNIFACGroups::get(const label index)
{
    return groups[index];
}


Foam::scalar Foam::dew::UNIFACGroups::a(const label i, const label j)
{
    return interaction[groups[i].main][groups[j].main];
}


Foam::wordList Foam::dew::UNIFACGroups::names()
{
    DynamicList<word> names;
    for (const group& g : groups)
    {
        names.append(g.name);
    }
    return wordList(std::move(names));
}
