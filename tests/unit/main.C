/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Unit tests of the project: argList gives OpenFOAM its environment, then
// every test of the linked files is run.

#include <gtest/gtest.h>
#include "IOobject.H"
#include "error.H"

int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);

    // An error of OpenFOAM is an exception here
    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();

    return RUN_ALL_TESTS();
}
