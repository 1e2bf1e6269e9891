/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "packedInsertion.H"
#include "addToRunTimeSelectionTable.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "Pstream.H"
#include "sphereGrid.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace insertionModels
{
    defineTypeName(packedInsertion);
    addToRunTimeSelectionTable(insertionModel, packedInsertion, dictionary);
}
}
}

namespace
{
    // Streams of random numbers: sizes and places are independent of another
    constexpr uint64_t sizeStream = 1, placeStream = 2;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::insertionModels::packedInsertion::packedInsertion
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const particleBox& box,
    const Time& time
)
:
    insertionModel(name, dict, mats, box, time),
    diameter_(sizeDistribution::New(userEntry::subDict(dict, "diameter"))),
    region_(insertionRegion::New(userEntry::subDict(dict, "region"))),
    maxAttempts_(dict.getOrDefault<label>("maxAttempts", 20000)),
    next_(-1)
{
    userEntry::onlyThese
    (
        dict,
        {
            "type", "material", "velocity", "omega", "T", "seed", "number",
            "porosity", "diameter", "region", "maxAttempts"
        }
    );

    if (dict.found("number") == dict.found("porosity"))
    {
        FatalIOErrorInFunction(dict)
            << "In " << dict.dictName()
            << " give one of number and porosity"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::scalar>
Foam::dew::insertionModels::packedInsertion::diameters() const
{
    counterRandom random(seed_, sizeStream);
    DynamicList<scalar> d;

    if (dict_.found("number"))
    {
        const label n = userEntry::count(dict_, "number");
        for (label i = 0; i < n; i++)
        {
            d.append(diameter_->sample(random));
        }
    }
    else
    {
        const scalar porosity = userEntry::within(dict_, "porosity", 0, 1);
        scalar rest = (1 - porosity)*region_->volume();

        while (true)
        {
            const scalar di = diameter_->sample(random);
            rest -= constant::mathematical::pi/6*pow3(di);
            if (rest < 0)
            {
                break;
            }
            d.append(di);
        }
    }

    return List<scalar>(d);
}


void Foam::dew::insertionModels::packedInsertion::place()
{
    d_ = diameters();
    x_.setSize(d_.size());

    // Large ones first: they would not find room among the small
    labelList order(sortedOrder(d_));
    reverse(order);

    counterRandom random(seed_, placeStream);
    sphereGrid grid(box_, 0.5*diameter_->max());
    const boundBox bb(region_->bounds());
    label placed = 0;

    for (const label i : order)
    {
        const scalar r = 0.5*d_[i];
        label attempt = 0;

        for (; attempt < maxAttempts_; attempt++)
        {
            point p;
            for (direction k = 0; k < 3; k++)
            {
                p[k] = bb.min()[k] + random.uniform()*bb.span()[k];
            }

            if (region_->holds(p, r) && grid.overlapping(p, r) < 0)
            {
                x_[i] = p;
                grid.append(p, r);
                break;
            }
        }

        if (attempt == maxAttempts_)
        {
            FatalIOErrorInFunction(dict_)
                << "No room in the region of " << dict_.dictName()
                << " after " << placed << " of " << d_.size()
                << " particles" << nl
                << "Ask for fewer (number, porosity), enlarge the region, or"
                << " raise maxAttempts (" << maxAttempts_ << ")"
                << exit(FatalIOError);
        }
        placed++;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::insertionModels::packedInsertion::initial(particleList& chunk)
{
    chunk.clear();

    if (Pstream::master())
    {
        if (next_ < 0)
        {
            place();
            next_ = 0;
        }

        const label end = min(next_ + particleList::chunk, x_.size());
        for (; next_ < end; next_++)
        {
            chunk.append
            (
                material_, x_[next_], velocity_, omega_, d_[next_], T_
            );
        }

        if (chunk.size() == 0)
        {
            x_.clear();
            d_.clear();
        }
    }

    chunk.scatter();

    return chunk.size() > 0;
}
