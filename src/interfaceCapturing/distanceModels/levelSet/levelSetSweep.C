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
        const vector n(-normalised(gradient_[celli]));

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
                            surface_, l, psi[celli], n, gradn_[celli]
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


Foam::scalar Foam::dew::distanceModels::levelSet::bounded
(
    const label i,
    const scalar value,
    const scalarField& psi
) const
{
    const label celli = band_.cell()[i];
    const scalar sign = surface_.alpha()[celli] > 0.5 ? 1 : -1;

    scalar far = max(sign*value, scalar(0));
    for (const cellLinks::link& l : band_.of(i))
    {
        if (l.patch == cellLinks::inside)
        {
            const scalar other =
                l.cell >= 0 ? psi[l.cell] : psiBehind_[-1 - l.cell];
            far = min(far, mag(other) + 1.05*mag(l.d));
        }
    }
    return sign*far;
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
    scalar leaving = 0;
    for (const cellLinks::link& l : band_.of(i))
    {
        const scalar out = away & l.S;
        scalar rise = g & l.toFace;
        if (out < 0 && l.patch == cellLinks::inside)
        {
            rise =
                l.cell >= 0
              ? psi[l.cell] - psi[celli] + (gradient_[l.cell] & l.toFaceBack)
              : psiBehind_[-1 - l.cell] - psi[celli]
              + (gradientBehind_[-1 - l.cell] & l.toFaceBack);
        }
        slope += out*rise;
        leaving += max(out, scalar(0));
    }
    const scalar V = surface_.mesh().V()[celli];
    const scalar dtau = 0.4*V/max(leaving, V/dx_[i]);
    return dtau*(S - mag(S)*slope/V);
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
            next[i] = held_[i] ? old : bounded(i, old + change(i, psi), psi);
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
