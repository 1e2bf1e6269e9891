/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "eddyInteraction.H"
#include "addToRunTimeSelectionTable.H"
#include "counterRandom.H"
#include "mathematicalConstants.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace seenVelocityModels
{
    defineTypeName(eddyInteraction);
    addToRunTimeSelectionTable(seenVelocityModel, eddyInteraction, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::seenVelocityModels::eddyInteraction::eddyInteraction
(
    const dictionary& dict
)
:
    seed_(userEntry::count(dict, "seed")),
    C_(userEntry::positiveOr(dict, "C", dimless, 0.164))
{
    userEntry::onlyThese(dict, {"type", "seed", "C"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::seenVelocityModels::eddyInteraction::meet
(
    scalar* m,
    const particle& p,
    const carrier& c
) const
{
    const scalar speed = sqrt(2*c.motion.k/3);

    // Four uniform numbers an eddy, three normal ones (Box and Muller)
    counterRandom random
    (
        uint64_t(seed_), uint64_t(p.id), uint64_t(4*m[count])
    );
    const scalar r0 = sqrt(-2*log(random.uniform()));
    const scalar a0 = constant::mathematical::twoPi*random.uniform();
    const scalar r1 = sqrt(-2*log(random.uniform()));
    const scalar a1 = constant::mathematical::twoPi*random.uniform();

    m[velocity] = speed*r0*cos(a0);
    m[velocity + 1] = speed*r0*sin(a0);
    m[velocity + 2] = speed*r1*cos(a1);
    m[length] = C_*pow(c.motion.k, 1.5)/c.motion.epsilon;
    m[life] = m[length]/speed;
    m[count]++;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::seenVelocityModels::eddyInteraction::correct
(
    const particle& p,
    carrier& c
) const
{
    scalar* m = p.memory;
    const vector eddy(m[velocity], m[velocity + 1], m[velocity + 2]);

    m[life] -= m[step];
    m[length] -= mag(c.U + eddy - p.U)*m[step];
    m[step] = c.deltaT;

    // Ends within the coming step: the nearer of the two step ends
    if (m[life] < 0.5*c.deltaT || m[length] < 0)
    {
        if (c.motion.k > VSMALL && c.motion.epsilon > VSMALL)
        {
            meet(m, p, c);
        }
        else
        {
            m[velocity] = m[velocity + 1] = m[velocity + 2] = 0;
        }
    }

    c.U += vector(m[velocity], m[velocity + 1], m[velocity + 2]);
}
