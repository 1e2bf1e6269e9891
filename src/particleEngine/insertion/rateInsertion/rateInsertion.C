/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rateInsertion.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "sphereGrid.H"
#include "timeIntegral.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace insertionModels
{
    defineTypeName(rateInsertion);
    addToRunTimeSelectionTable(insertionModel, rateInsertion, dictionary);
}
}
}

namespace
{
    constexpr uint64_t sizeStream = 1, placeStream = 2;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::insertionModels::rateInsertion::rateInsertion
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
    byMass_(dict.found("massRate")),
    start_(userEntry::notNegativeOr(dict, "start", dimTime, 0)),
    end_(userEntry::notNegativeOr(dict, "end", dimTime, VGREAT)),
    attempts_
    (
        dict.found("attempts") ? userEntry::count(dict, "attempts") : 20
    ),
    owed_(0),
    sizes_(0),
    places_(0)
{
    userEntry::onlyThese
    (
        dict,
        {
            "type", "material", "velocity", "omega", "T", "seed",
            "numberRate", "massRate", "diameter", "region", "start", "end",
            "attempts"
        }
    );

    if (dict.found("numberRate") == byMass_)
    {
        FatalIOErrorInFunction(dict)
            << "In " << dict.dictName()
            << " give one of numberRate and massRate"
            << exit(FatalIOError);
    }

    if (cmptMin(region_->bounds().span()) < diameter_->max())
    {
        FatalIOErrorInFunction(dict)
            << "The region of insertion '" << name << "' spans "
            << region_->bounds().span() << ", a particle may have a diameter of "
            << diameter_->max() << nl << "Enlarge the region"
            << exit(FatalIOError);
    }

    rate_ = Function1<scalar>::New(byMass_ ? "massRate" : "numberRate", dict);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::insertionModels::rateInsertion::nextDiameter() const
{
    // A stream for each particle: a rejected draw shifts no other
    counterRandom random(seed_, sizeStream + 2*uint64_t(sizes_));
    return diameter_->sample(random);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::insertionModels::rateInsertion::propose
(
    const scalar t0,
    const scalar t1,
    particleList& list
)
{
    list.clear();

    const scalar a = max(t0, start_);
    const scalar b = min(t1, end_);

    if (b > a)
    {
        const scalar due = timeIntegral(rate_(), a, b);
        if (due < 0)
        {
            FatalIOErrorInFunction(dict_)
                << "The rate of insertion '" << name_ << "' is negative between"
                << " the times " << a << " and " << b << ": " << due/(b - a)
                << nl
                << "Entry '" << (byMass_ ? "massRate" : "numberRate")
                << "' must be zero or greater at all times"
                << exit(FatalIOError);
        }
        owed_ += due;
    }

    while (true)
    {
        const scalar d = nextDiameter();
        const scalar share =
            byMass_
          ? materials_.density(material_)*constant::mathematical::pi/6*pow3(d)
          : 1;

        // Round-off of the integral must not hold back the last particle
        if (owed_ < share*(1 - 1e-9))
        {
            break;
        }
        owed_ -= share;
        sizes_++;
        waiting_.append(d);
    }

    sphereGrid grid(box_, 0.5*diameter_->max());
    const boundBox bb(region_->bounds());
    counterRandom random(seed_, placeStream, places_);

    offered_.clear();
    forAll(waiting_, w)
    {
        const scalar d = waiting_[w];
        const scalar r = 0.5*d;

        point p;
        for (direction k = 0; k < 3; k++)
        {
            p[k] = bb.min()[k] + r + random.uniform()*(bb.span()[k] - d);
        }
        if (region_->holds(p, r) && grid.overlapping(p, r) < 0)
        {
            grid.append(p, r);
            list.append(material_, p, velocity_, omega_, d, T_);
            offered_.append(w);
        }
    }

    places_ = random.counter();
}


void Foam::dew::insertionModels::rateInsertion::placed(const UList<bool>& found)
{
    // offered_ is in ascending order
    DynamicList<scalar> rest;
    label next = 0;

    forAll(waiting_, w)
    {
        bool in = false;
        if (next < offered_.size() && offered_[next] == w)
        {
            in = next < found.size() && found[next];
            next++;
        }
        if (!in)
        {
            rest.append(waiting_[w]);
        }
    }

    waiting_.transfer(rest);
}


void Foam::dew::insertionModels::rateInsertion::write(dictionary& dict) const
{
    dict.add("owed", owed_);
    dict.add("sizes", sizes_);
    dict.add("places", scalar(places_));     // exact to 2^53
    dict.add("waiting", List<scalar>(waiting_));
}


void Foam::dew::insertionModels::rateInsertion::read(const dictionary& dict)
{
    dict.readEntry("owed", owed_);
    dict.readEntry("sizes", sizes_);
    places_ = uint64_t(dict.get<scalar>("places"));
    waiting_ = dict.get<List<scalar>>("waiting");
}
