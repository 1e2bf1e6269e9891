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


void Foam::dew::distanceModels::levelSet::fetchGradient()
{
    cellLinks::fetch(surface_.mesh(), gradient_, gradientBehind_);
}


void Foam::dew::distanceModels::levelSet::calculateGradient
(
    const scalarField& psi
)
{
    forAll(band_.cell(), i)
    {
        const label celli = band_.cell()[i];
        vector g(Zero);
        for (const cellLinks::link& l : band_.of(i))
        {
            if (l.patch == cellLinks::unknown)
            {
                continue;
            }
            scalar rise = -psi[celli];
            if (l.patch >= 0)
            {
                rise =
                  - (
                        wallContact::normal
                        (
                            surface_, l, psi[celli],
                            -normalised(gradient_[celli]), gradn_[celli]
                        )
                      & l.d
                    );
            }
            else
            {
                rise += l.cell >= 0 ? psi[l.cell] : psiBehind_[-1 - l.cell];
            }
            g += rise*l.w;
        }
        gradient_[celli] = g;
    }
    fetchGradient();
}


Foam::scalar Foam::dew::distanceModels::levelSet::stepped
(
    const label i,
    const scalarField& psi
) const
{
    const label celli = band_.cell()[i];
    const scalar old = psi[celli];
    const vector& g = gradient_[celli];
    const scalar S = old/Foam::sqrt(sqr(old) + sqr(0.5*dx_[i]));
    const vector away(S < 0 ? -normalised(g) : normalised(g));

    scalar slope = 0;
    scalar leaving = 0;
    scalar furthest = GREAT;
    for (const cellLinks::link& l : band_.of(i))
    {
        const scalar out = away & l.S;
        scalar rise = g & l.toFace;
        if (l.patch == cellLinks::inside)
        {
            const bool here = l.cell >= 0;
            const label k = here ? l.cell : -1 - l.cell;
            const scalar other = here ? psi[k] : psiBehind_[k];
            if (out < 0)
            {
                rise =
                    other - old
                  + (
                        (here ? gradient_[k] : gradientBehind_[k])
                      & (l.toFace - l.d)
                    );
            }
            furthest = min(furthest, mag(other) + 1.05*l.length);
        }
        slope += out*rise;
        leaving += max(out, scalar(0));
    }
    const scalar V = surface_.mesh().cellVolumes()[celli];
    const scalar dtau = 0.4*V/max(leaving, V/dx_[i]);

    const scalar sign = surface_.alpha()[celli] > 0.5 ? 1 : -1;
    const scalar value = old + dtau*(S - mag(S)*slope/V);
    return sign*min(max(sign*value, scalar(0)), furthest);
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
            next[i] = held_[i] ? psi[band_.cell()[i]] : stepped(i, psi);
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
    const label i,
    const scalarField& psi
) const
{
    const label celli = band_.cell()[i];
    const vector n(-normalised(gradient_[celli]));

    tensor gradn(Zero);
    for (const cellLinks::link& l : band_.of(i))
    {
        if (l.patch == cellLinks::unknown)
        {
            continue;
        }
        const vector other
        (
            l.patch >= 0
          ? wallContact::normal(surface_, l, psi[celli], n, gradn_[celli])
          : l.cell >= 0 ? -normalised(gradient_[l.cell])
          : -normalised(gradientBehind_[-1 - l.cell])
        );
        gradn += l.w*(other - n);
    }
    return gradn;
}


void Foam::dew::distanceModels::levelSet::calculateGradientOfNormal
(
    const scalarField& psi
)
{
    forAll(band_.cell(), i)
    {
        if (held_[i])
        {
            gradn_[band_.cell()[i]] = gradientOfNormal(i, psi);
        }
    }

    // At walls away from the contact line, that of the surface
    List<label> layerBehind;
    cellLinks::fetch(surface_.mesh(), layer_, layerBehind);
    List<tensor> gradnBehind;
    for (label layer = 1; layer <= nLayers; layer++)
    {
        cellLinks::fetch(surface_.mesh(), gradn_, gradnBehind);
        for (const label i : atWalls_)
        {
            const label celli = band_.cell()[i];
            if (layer_[celli] != layer)
            {
                continue;
            }
            tensor sum(Zero);
            label n = 0;
            for (const cellLinks::link& l : band_.of(i))
            {
                if (l.patch != cellLinks::inside)
                {
                    continue;
                }
                const bool here = l.cell >= 0;
                const label k = here ? l.cell : -1 - l.cell;
                if ((here ? layer_[k] : layerBehind[k]) == layer - 1)
                {
                    sum += here ? gradn_[k] : gradnBehind[k];
                    n++;
                }
            }
            gradn_[celli] = sum/max(n, 1);
        }
    }
}
