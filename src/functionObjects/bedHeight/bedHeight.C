/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bedHeight.H"
#include "addToRunTimeSelectionTable.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(bedHeight);
    addToRunTimeSelectionTable(functionObject, bedHeight, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Volume of a sphere below a height over its lowest point
Foam::scalar cap(const Foam::scalar d, const Foam::scalar h)
{
    const Foam::scalar z = Foam::min(Foam::max(h, Foam::scalar(0)), d);
    return Foam::constant::mathematical::pi/6*z*z*(3*d - 2*z);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::bedHeight::bedHeight
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    functionObjects::regionFunctionObject(name, time, dict),
    file_("bedHeight.dat")
{
    read(dict);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::bedHeight::below
(
    const particleState& s,
    const scalar h
) const
{
    scalar sum = 0;
    for (label i = 0; i < s.size(); i++)
    {
        sum += cap(s.d[i], h - height(s, i) + 0.5*s.d[i]);
    }
    return sum;
}


Foam::scalar Foam::dew::bedHeight::shareHeight
(
    const particleState& s,
    const scalar volume,
    scalar low,
    scalar high
) const
{
    // To 1e-10 of the bed
    for (label n = 0; n < 34; n++)
    {
        const scalar middle = 0.5*(low + high);
        const scalar sum = returnReduce(below(s, middle), sumOp<scalar>());
        (sum < volume ? low : high) = middle;
    }
    return 0.5*(low + high);
}


Foam::scalarList Foam::dew::bedHeight::profile
(
    const particleState& s,
    const scalar top
) const
{
    const scalar n = max(scalar(1), std::ceil(top/binHeight_));
    if (n > 1e6)
    {
        FatalErrorInFunction
            << "Function object " << name() << ": the bed is " << top
            << " m high, which is " << n << " bins of binHeight "
            << binHeight_ << " m" << nl << "Use a larger binHeight"
            << exit(FatalError);
    }

    scalarList bins(label(n), Zero);
    for (label i = 0; i < s.size(); i++)
    {
        const scalar d = s.d[i], foot = height(s, i) - 0.5*d;

        // From bin to bin, what is below its upper end
        label k = max(label(0), label(foot/binHeight_));
        scalar lower = cap(d, k*binHeight_ - foot);
        for (; k < bins.size() && k*binHeight_ < foot + d; k++)
        {
            const scalar upper = cap(d, (k + 1)*binHeight_ - foot);
            bins[k] += upper - lower;
            lower = upper;
        }
    }
    Pstream::listCombineGather(bins, plusEqOp<scalar>());
    return bins;
}


Foam::scalar Foam::dew::bedHeight::profileHeight
(
    const scalarList& bins,
    const scalar mean
) const
{
    // Of the bins whose middle is below the mean, at least the first
    const label n =
        min(max(label(1), label(mean/binHeight_ + 0.5)), bins.size());
    scalar half = 0;
    for (label k = 0; k < n; k++)
    {
        half += 0.5*bins[k]/n;
    }

    label k = bins.size() - 1;
    while (k > 0 && bins[k] < half)
    {
        k--;
    }
    const scalar above = k + 1 < bins.size() ? bins[k + 1] : 0;
    const scalar fall = bins[k] - above;

    return
        bins[k] < half || fall <= 0
      ? 0
      : binHeight_*(k + 0.5 + (bins[k] - half)/fall);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::bedHeight::read(const dictionary& dict)
{
    regionFunctionObject::read(dict);

    direction_ = userEntry::direction(dict, "direction");
    base_ = userEntry::pointOr(dict, "base", dimLength, Zero);
    share_ =
        dict.found("share") ? userEntry::within(dict, "share", 0, 1) : 0.95;
    binHeight_ = userEntry::positive(dict, "binHeight", dimLength);

    userEntry::onlyThese
    (
        dict,
        seriesFile::entries({"direction", "base", "share", "binHeight"})
    );

    return true;
}


bool Foam::dew::bedHeight::execute()
{
    const particleState& s = seriesFile::particles(obr_, *this).state();

    scalar volume = 0, moment = 0, low = GREAT, high = -GREAT;
    for (label i = 0; i < s.size(); i++)
    {
        const scalar h = height(s, i), V = s.volume(i);
        volume += V;
        moment += V*h;
        low = min(low, h - 0.5*s.d[i]);
        high = max(high, h + 0.5*s.d[i]);
    }
    const label n = returnReduce(s.size(), sumOp<label>());

    scalarList row(4, Zero);
    row[0] = n;
    if (n)
    {
        reduce(volume, sumOp<scalar>());
        reduce(moment, sumOp<scalar>());
        reduce(low, minOp<scalar>());
        reduce(high, maxOp<scalar>());

        const scalar mean = moment/volume;
        row[1] = 2*mean;
        row[2] = shareHeight(s, share_*volume, low, high);
        row[3] = profileHeight(profile(s, high), mean);
    }

    if (Pstream::master())
    {
        file_.line
        (
            time_, name(),
            "particles, heights [m]: twice the mean, below which a share of"
            " the volume lies, where the profile falls to half",
            row
        );
    }
    return true;
}
