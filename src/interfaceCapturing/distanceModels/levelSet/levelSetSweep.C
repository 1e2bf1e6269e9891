/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "levelSet.H"
#include "transportedSurface.H"
#include "wallContact.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::distanceModels::levelSet::fetch(const scalarField& psi)
{
    cellLinks::fetch(surface_.mesh(), psi, psiBehind_);
}


void Foam::dew::distanceModels::levelSet::calculateGradient
(
    const scalarField& psi
)
{
    forAll(band_.cell(), i)
    {
        const label celli = band_.cell()[i];
        const vector n(-normalised(gradient_[celli]));

        vector g(Zero);
        for (const cellLinks::link& l : band_.of(i))
        {
            g +=
                l.w
               *(
                    l.patch >= 0
                  ? -(wallContact::normal(surface_, l, n) & l.d)
                  : (l.cell >= 0 ? psi[l.cell] : psiBehind_[-1 - l.cell])
                  - psi[celli]
                );
        }
        gradient_[celli] = g;
    }
    cellLinks::fetch(surface_.mesh(), gradient_, gradientBehind_);
}


Foam::scalar Foam::dew::distanceModels::levelSet::change
(
    const label i,
    const scalarField& psi
) const
{
    const label celli = band_.cell()[i];
    const vector& g = gradient_[celli];
    const scalar S =
        psi[celli]/Foam::sqrt(sqr(psi[celli]) + sqr(0.5*dx_[i]));
    const vector away(S < 0 ? -normalised(g) : normalised(g));

    scalar slope = 0;
    for (const cellLinks::link& l : band_.of(i))
    {
        const scalar out = away & l.S;
        scalar rise = g & l.toFace;
        if (out < 0 && l.patch < 0)
        {
            rise =
                l.cell >= 0
              ? psi[l.cell] - psi[celli] + (gradient_[l.cell] & l.toFaceBack)
              : psiBehind_[-1 - l.cell] - psi[celli]
              + (gradientBehind_[-1 - l.cell] & l.toFaceBack);
        }
        slope += out*rise;
    }
    return mag(S)*((S < 0 ? -1 : 1) - slope/surface_.mesh().V()[celli]);
}


void Foam::dew::distanceModels::levelSet::sweep
(
    const label times,
    scalarField& psi
)
{
    fetch(psi);
    calculateGradient(psi);

    scalarField next(band_.cell().size());
    for (label sweepi = 0; sweepi < times; sweepi++)
    {
        forAll(next, i)
        {
            const scalar old = psi[band_.cell()[i]];
            next[i] = held_[i] ? old : old + 0.1*dx_[i]*change(i, psi);
        }
        forAll(next, i)
        {
            psi[band_.cell()[i]] = next[i];
        }
        fetch(psi);
        calculateGradient(psi);
    }
}


Foam::tensor Foam::dew::distanceModels::levelSet::gradientOfNormal
(
    const label i
) const
{
    const label celli = band_.cell()[i];
    const vector n(-normalised(gradient_[celli]));

    tensor gradn(Zero);
    for (const cellLinks::link& l : band_.of(i))
    {
        const vector other
        (
            l.patch >= 0 ? wallContact::normal(surface_, l, n)
          : l.cell >= 0 ? -normalised(gradient_[l.cell])
          : -normalised(gradientBehind_[-1 - l.cell])
        );
        gradn += l.w*(other - n);
    }
    return gradn;
}
