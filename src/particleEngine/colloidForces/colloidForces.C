/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "colloidForces.H"
#include "liggghtsTimeStep.H"
#include "userEntry.H"

// Largest way into each other in a sub-step, over the radius
static const Foam::scalar overlap = 0.01;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidForces::colloidForces
(
    const dictionary& dict,
    const materials& mats,
    const scalar R
)
:
    materials_(mats),
    medium_(dict),
    rough_(mats.size()*mats.size()),
    roughWalls_(mats.size()*mats.size())
{
    const dictionary& forces = userEntry::subDict(dict, "forces");
    for (const entry& e : forces)
    {
        laws_.append
        (
            colloidLaw::New(userEntry::dictOf(forces, e), medium_, mats).ptr()
        );
    }
    check(dict, R);
    roughen(dict, R);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Law>
Foam::dew::colloidForce Foam::dew::colloidForces::sum
(
    const double h,
    const Law& law
) const
{
    colloidForce total{0, 0};
    for (const colloidLaw& one : laws_)
    {
        total += law(one, h);
    }
    return total;
}


template<class Force>
Foam::dew::colloidForce Foam::dew::colloidForces::within
(
    const double h,
    const Force& force
) const
{
    return
        h < cutOff()
      ? heldBelow(medium_.minGap(), h, force)
      : colloidForce{0, 0};
}


template<class Force>
Foam::dew::colloidForces::steepness Foam::dew::colloidForces::steepest
(
    const Force& F
) const
{
    // Gaps of equal ratio; the slope over each is below 1 % of the largest
    const int n = 2000;
    const scalar least = max(medium_.minGap(), 1e-4*cutOff());
    const scalar ratio = pow(cutOff()*(1 - 1e-9)/least, 1.0/n);
    scalar h = least, before = F(h);
    steepness most;
    most.pull = max(-before, scalar(0));
    for (int i = 0; i < n; i++)
    {
        const scalar next = F(h*ratio);
        const scalar slope = (next - before)/(h*(ratio - 1));
        most.back = max(most.back, -slope);
        most.on = max(most.on, slope);
        most.pull = max(most.pull, -next);
        before = next;
        h *= ratio;
    }
    return most;
}


void Foam::dew::colloidForces::check
(
    const dictionary& dict,
    const scalar R
) const
{
    label nVanDerWaals = 0;
    for (const colloidLaw& law : laws_)
    {
        nVanDerWaals += law.wallVanDerWaals();
        if (medium_.minGap() <= 0 && law.needsMinGap())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'minGap' in " << dict.dictName() << " is 0, but the"
                << " force " << law.type() << " has no bound at contact" << nl
                << "Give the least gap, 2e-10 to 1e-9 m is usual"
                << exit(FatalIOError);
        }
    }

    if (nVanDerWaals > 1)
    {
        FatalIOErrorInFunction(dict)
            << "The van der Waals force of walls is in " << nVanDerWaals
            << " laws of forces in " << dict.dictName() << nl
            << "Keep one: set 'vanDerWaals off;' in that of type"
            << " LennardJonesWall"
            << exit(FatalIOError);
    }

    if (medium_.kappa()*cutOff() < 1 && medium_.kappa() > 0)
    {
        scalar most = 0;
        for (label i = 0; i < materials_.size(); i++)
        {
            most = max(most, mag(pair(i, i, R, R, cutOff()*(1 - 1e-9)).U));
        }
        FatalIOErrorInFunction(dict)
            << "The Debye length " << 1/medium_.kappa() << " m is beyond"
            << " 'cutOff' " << cutOff() << " m in " << dict.dictName()
            << ", where a pair of the smallest particles still has "
            << most/medium_.kT() << " kT" << nl
            << "Raise cutOff to some 5 Debye lengths, "
            << 5/medium_.kappa() << " m"
            << exit(FatalIOError);
    }
}


Foam::scalarList Foam::dew::colloidForces::roughness
(
    const dictionary& dict
) const
{
    if (!dict.isDict("roughness"))
    {
        return scalarList
        (
            materials_.size(),
            userEntry::notNegativeOr(dict, "roughness", dimLength, 0)
        );
    }

    const dictionary& each = userEntry::subDict(dict, "roughness");
    userEntry::onlyThese(each, materials_.names());
    scalarList s;
    for (const word& name : materials_.names())
    {
        s.append(userEntry::notNegativeOr(each, name, dimLength, 0));
    }
    return s;
}


void Foam::dew::colloidForces::roughen
(
    const dictionary& dict,
    const scalar R
)
{
    const scalarList one(roughness(dict));
    const scalar least = medium_.minGap();
    for (const scalar s : one)
    {
        if (s > 0 && s < 0.05*least)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'roughness' in " << dict.dictName() << " is " << s
                << " m, below 5 % of minGap " << least << " m: no force feels"
                << " it" << nl << "Remove it, or lower minGap"
                << exit(FatalIOError);
        }
        if (s > 0 && least <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'roughness' in " << dict.dictName() << " needs"
                << " minGap > 0, for rough surfaces touch in places" << nl
                << "Give the least gap, 2e-10 to 1e-9 m is usual"
                << exit(FatalIOError);
        }
    }

    const label n = materials_.size();
    for (label i = 0; i < n; i++)
    {
        for (label j = 0; j < n; j++)
        {
            const scalar s = hypot(one[i], one[j]);
            const auto table = [&](const bool wall)
            {
                return new roughForceTable
                (
                    s, least, cutOff(), R, wall,
                    [&](const double h, const double R1, const double R2)
                    {
                        return heldBelow(least, h, [&](const double gap)
                        {
                            return sum
                            (
                                gap,
                                [&](const colloidLaw& law, const double g)
                                {
                                    return
                                        wall
                                      ? law.wall(i, j, R1, g)
                                      : law.pair(i, j, R1, R2, g);
                                }
                            );
                        });
                    }
                );
            };
            if (s > 0)
            {
                roughWalls_.set(at(i, j), table(true));
            }
            if (s > 0 && i <= j)
            {
                rough_.set(at(i, j), table(false));
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::colloidForce Foam::dew::colloidForces::pair
(
    int i, int j, double Ri, double Rj, double h
) const
{
    return within(h, [&](const double gap)
    {
        const roughForceTable* rough = rough_(at(min(i, j), max(i, j)));
        return
            rough
          ? (*rough)(gap, Ri, Rj)
          : sum(gap, [&](const colloidLaw& law, const double g)
            {
                return law.pair(i, j, Ri, Rj, g);
            });
    });
}


Foam::dew::colloidForce Foam::dew::colloidForces::wall
(
    int i, int wall, double R, double h
) const
{
    return within(h, [&](const double gap)
    {
        const roughForceTable* rough = roughWalls_(at(i, wall));
        return
            rough
          ? (*rough)(gap, R, std::numeric_limits<double>::infinity())
          : sum(gap, [&](const colloidLaw& law, const double g)
            {
                return law.wall(i, wall, R, g);
            });
    });
}


Foam::scalar Foam::dew::colloidForces::stableTimeStep
(
    const scalar R,
    const scalar mu
) const
{
    scalar least = GREAT;
    // bodies: 2 of a pair, 1 at a wall
    const auto limit =
        [&](const scalar m, const label bodies, const steepness& most)
    {
        const scalar pull = bodies*most.pull/(overlap*R);
        const scalar k =
            max(most.back, mu > 0 ? min(most.on, pull) : most.on);
        if (k > 0)
        {
            const scalar limit =
                mu > 0 ? overdampedTime(R, mu, k) : 2*sqrt(m/(bodies*k));
            least = min(least, limit);
        }
    };

    for (label i = 0; i < materials_.size(); i++)
    {
        const scalar m =
            4.0/3.0*constant::mathematical::pi*pow3(R)*materials_.density(i);

        for (label j = 0; j < materials_.size(); j++)
        {
            const auto two = [&](const scalar h)
            {
                return pair(i, j, R, R, h).F;
            };
            const auto one = [&](const scalar h) { return wall(i, j, R, h).F; };
            limit(m, 2, steepest(two));
            limit(m, 1, steepest(one));
        }
    }
    return least;
}
