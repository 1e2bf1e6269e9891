/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "speciesData.H"
#include "DynamicList.H"
#include "error.H"
#include "FlatOutput.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::dew::speciesData;

// In the order of the members
const speciesData table[] =
{
    {"He", "helium", 4.0026, 2.67, 2.551, 10.22,
        5.19, 2.27e+05, -0.39, 1, ""},
    {"Ar", "argon", 39.948, 16.2, 3.542, 93.3,
        150.86, 4.8981e+06, 0, 1, ""},
    {"H2", "hydrogen", 2.01588, 6.12, 2.827, 59.7,
        33.2, 1.297e+06, -0.22, 1, ""},
    {"N2", "nitrogen", 28.0134, 18.5, 3.798, 71.4,
        126.1, 3.3944e+06, 0.0403, 1, ""},
    {"O2", "oxygen", 31.9988, 16.3, 3.467, 106.7,
        154.58, 5.043e+06, 0.0222, 1, ""},
    {"air", "air", 28.9647, 19.7, 3.711, 78.6,
        132.5, 3.786e+06, 0.035, 1, ""},
    {"CO", "carbonMonoxide", 28.0101, 18, 3.69, 91.7,
        132.9, 3.499e+06, 0.048, 1, ""},
    {"CO2", "carbonDioxide", 44.0095, 26.9, 3.941, 195.2,
        304.2, 7.383e+06, 0.2236, 1, ""},
    {"CH4", "methane", 16.0425, 25.14, 3.758, 148.6,
        190.56, 4.599e+06, 0.0115, 1, ""},
    {"H2O", "water", 18.015, 13.1, 2.641, 809.1,
        647.13, 2.2055e+07, 0.3449, 2.6, "1 H2O"},
    {"CH3OH", "methanol", 32.042, 31.25, 3.626, 481.8,
        512.58, 8.0959e+06, 0.5656, 1.9, "1 CH3OH"},
    {"C2H5OH", "ethanol", 46.069, 51.77, 4.53, 362.6,
        516.25, 6.3835e+06, 0.6371, 1.5, "1 CH3 1 CH2 1 OH"},
    {"nC3H8O", "propanol", 60.096, 72.29, 4.549, 576.7,
        536.71, 5.1696e+06, 0.6279, 1, "1 CH3 2 CH2 1 OH"},
    {"iC3H8O", "isopropanol", 60.096, 72.29, 4.885, 403.6,
        508.31, 4.7643e+06, 0.6689, 1, "2 CH3 1 CH 1 OH"},
    {"C3H6O", "acetone", 58.08, 67.67, 4.6, 560.2,
        508.2, 4.7015e+06, 0.3064, 1, "1 CH3 1 CH3CO"},
    {"C2H6O", "dimethylEther", 46.069, 51.77, 4.307, 395,
        400.1, 5.3702e+06, 0.2036, 1, "1 CH3 1 CH3O"},
    {"C4H10O", "diethylEther", 74.123, 92.81, 5.678, 313.8,
        466.7, 3.6376e+06, 0.2846, 1, "2 CH3 1 CH2 1 CH2O"},
    {"C2H6", "ethane", 30.07, 45.66, 4.443, 215.7,
        305.32, 4.872e+06, 0.0995, 1, "2 CH3"},
    {"C3H8", "propane", 44.096, 66.18, 5.118, 237.1,
        369.83, 4.248e+06, 0.1523, 1, "2 CH3 1 CH2"},
    {"C6H14", "hexane", 86.177, 127.7, 5.949, 399.3,
        507.6, 3.025e+06, 0.3013, 1, "2 CH3 4 CH2"},
    {"C6H6", "benzene", 78.114, 90.96, 5.349, 412.3,
        562.16, 4.898e+06, 0.2108, 1, "6 ACH"},
    {"C7H16", "heptane", 100.204, 148.3, 6.097, 429,
        540.2, 2.74e+06, 0.3495, 1, "2 CH3 5 CH2"},
    {"C8H18", "octane", 114.231, 168.8, 6.361, 451.6,
        568.7, 2.49e+06, 0.3996, 1, "2 CH3 6 CH2"},
    {"IC8H18", "isooctane", 114.231, 168.8, 6.281, 432,
        543.96, 2.5676e+06, 0.3031, 1, "5 CH3 1 CH2 1 CH 1 C"},
    {"C9H20", "nonane", 128.258, 189.3, 6.604, 472.2,
        594.6, 2.29e+06, 0.4435, 1, "2 CH3 7 CH2"},
    {"C10H22", "decane", 142.285, 209.8, 6.823, 490.5,
        617.7, 2.11e+06, 0.4923, 1, "2 CH3 8 CH2"},
    {"C12H26", "dodecane", 170.338, 250.9, 7.237, 522.5,
        658, 1.82e+06, 0.5764, 1, "2 CH3 10 CH2"},
    {"C13H28", "tridecane", 184.365, 271.4, 7.415, 536.6,
        675.8, 1.7225e+06, 0.6186, 1, "2 CH3 11 CH2"},
    {"C14H30", "tetradecane", 198.392, 291.9, 7.642, 549.8,
        692.4, 1.6212e+06, 0.6617, 1, "2 CH3 12 CH2"},
    {"C16H34", "hexadecane", 226.446, 332.9, 7.897, 572.2,
        720.6, 1.4186e+06, 0.7471, 1, "2 CH3 14 CH2"},
    {"C7H8", "toluene", 92.141, 111.5, 5.509, 469.9,
        591.79, 4.1086e+06, 0.2641, 1, "5 ACH 1 ACCH3"},
    {"C8H10", "ethylbenzene", 106.167, 132, 5.828, 490.1,
        617.17, 3.6094e+06, 0.3036, 1, "1 CH3 5 ACH 1 ACCH2"},
    {"MB", "methylButanoate", 102.133, 114.8, 5.646, 440.3,
        554.5, 3.4734e+06, 0.3807, 1, "2 CH3 1 CH2 1 CH2COO"},
    {"aC11H10", "alphaMethylnaphthalene", 142.2, 161.4, 6.518, 613.1,
        772.04, 3.66e+06, 0.3478, 1, "7 ACH 2 AC 1 ACCH3"},
    {"bC11H10", "betaMethylnaphthalene", 142.2, 161.4, 6.451, 604.3,
        761, 3.25e+06, 0.3459, 1, "7 ACH 2 AC 1 ACCH3"}
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

const Foam::dew::speciesData* Foam::dew::speciesData::find(const word& name)
{
    for (const speciesData& s : table)
    {
        if (name == s.name || name == s.commonName)
        {
            return &s;
        }
    }
    return nullptr;
}


const Foam::dew::speciesData& Foam::dew::speciesData::get
(
    const word& name,
    const char* what,
    const dictionary& dict
)
{
    const speciesData* found = find(name);
    if (!found && &dict != &dictionary::null)
    {
        FatalIOErrorInFunction(dict)
            << "No " << what << " is known of the species " << name << nl
            << "Known: " << flatOutput(names()) << exit(FatalIOError);
    }
    if (!found)
    {
        FatalErrorInFunction
            << "No " << what << " is known of the species " << name << nl
            << "Known: " << flatOutput(names()) << exit(FatalError);
    }
    return *found;
}


Foam::word Foam::dew::speciesData::nameOf(const word& nameOrCommonName)
{
    const speciesData* found = find(nameOrCommonName);
    return found ? word(found->name) : nameOrCommonName;
}


Foam::wordList Foam::dew::speciesData::names()
{
    DynamicList<word> names;
    for (const speciesData& s : table)
    {
        names.append(s.name);
    }
    return wordList(std::move(names));
}
