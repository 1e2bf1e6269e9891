/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tableColumns.H"

namespace Foam
{
namespace dew
{
namespace tableColumns
{

properties ofLiquid(const liquidModel& l)
{
    using F = const scalarField&;
    properties all;
    all.append({"rho", [&](scalar p, scalar T, F) { return l.rho(p, T); }});
    all.append({"mu", [&](scalar p, scalar T, F) { return l.mu(p, T); }});
    all.append({"Cp", [&](scalar p, scalar T, F) { return l.Cp(p, T); }});
    all.append({"kappa", [&](scalar p, scalar T, F) { return l.kappa(p, T); }});
    all.append({"hv", [&](scalar p, scalar T, F) { return l.hv(p, T); }});
    all.append({"sigma", [&](scalar p, scalar T, F) { return l.sigma(p, T); }});
    all.append({"pSat", [&](scalar, scalar T, F) { return l.pSat(T); }});
    return all;
}


properties ofGas(const pureGas& g)
{
    using F = const scalarField&;
    properties all;
    all.append({"Cp", [&](scalar, scalar T, F) { return g.Cp(T); }});
    all.append({"kappa", [&](scalar, scalar T, F) { return g.kappa(T); }});
    all.append({"mu", [&](scalar, scalar T, F) { return g.mu(T); }});
    return all;
}


properties ofMixture(const liquidMixture& m)
{
    using F = const scalarField&;
    properties all;
    all.append
    (
        {"rho", [&](scalar p, scalar T, F x) { return m.rho(p, T, x); }}
    );
    all.append({"mu", [&](scalar p, scalar T, F x) { return m.mu(p, T, x); }});
    all.append({"Cp", [&](scalar p, scalar T, F x) { return m.Cp(p, T, x); }});
    all.append
    (
        {"kappa", [&](scalar p, scalar T, F x) { return m.kappa(p, T, x); }}
    );
    all.append
    (
        {"sigma", [&](scalar p, scalar T, F x) { return m.sigma(p, T, x); }}
    );
    for (label i = 0; m.size() > 1 && i < m.size(); i++)
    {
        all.append
        (
            {
                "D." + m.names()[i],
                [&m, i](scalar p, scalar T, F x) { return m.D(i, p, T, x); }
            }
        );
    }
    return all;
}


properties ofEquilibrium(const vapourLiquidEquilibrium& e)
{
    properties all;
    const wordList& names = e.liquids().names();
    forAll(names, i)
    {
        all.append
        (
            {
                "gamma." + names[i],
                [&e, i](scalar, scalar T, const scalarField& x)
                {
                    scalarField g(x.size());
                    e.activity().lnGamma(T, x, g);
                    return std::exp(g[i]);
                }
            }
        );
        all.append
        (
            {
                "p." + names[i],
                [&e, i](scalar p, scalar T, const scalarField& x)
                {
                    scalarField pi(x.size());
                    e.partialPressures(p, T, x, pi);
                    return pi[i];
                }
            }
        );
    }
    return all;
}


properties ofBoiling(const vapourLiquidEquilibrium& e)
{
    properties all;
    all.append
    (
        {
            "Tboil",
            [&e](scalar p, scalar, const scalarField& x)
            {
                scalarField y(x.size());
                return e.bubbleT(p, x, y);
            }
        }
    );
    forAll(e.liquids().names(), i)
    {
        all.append
        (
            {
                "y." + e.liquids().names()[i],
                [&e, i](scalar p, scalar, const scalarField& x)
                {
                    scalarField y(x.size());
                    e.bubbleT(p, x, y);
                    return y[i];
                }
            }
        );
    }
    return all;
}


properties ofGasMixture(const gasMixture& g)
{
    using F = const scalarField&;
    const auto Y = [&g](F x)
    {
        scalarField Y(x.size());
        g.massFractions(x, Y);
        return Y;
    };
    properties all;
    all.append
    (
        {"rho", [&g, Y](scalar p, scalar T, F x) { return g.rho(p, T, Y(x)); }}
    );
    all.append
    (
        {"Cp", [&g, Y](scalar, scalar T, F x) { return g.Cp(T, Y(x)); }}
    );
    all.append
    (
        {"kappa", [&g, Y](scalar, scalar T, F x) { return g.kappa(T, Y(x)); }}
    );
    all.append
    (
        {"mu", [&g, Y](scalar, scalar T, F x) { return g.mu(T, Y(x)); }}
    );
    for (label i = 0; i < g.size(); i++)
    {
        all.append
        (
            {
                "D." + g.names()[i],
                [&g, Y, i](scalar p, scalar T, F x)
                {
                    return g.DY(i, p, T, Y(x));
                }
            }
        );
    }
    return all;
}

} // End namespace tableColumns
} // End namespace dew
} // End namespace Foam
