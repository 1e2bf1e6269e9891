/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidPhase.H"
#include "Enum.H"
#include "interfaceFaces.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liquidPhase::liquidPhase
(
    const liquidMixture& liquids,
    const fvMesh& mesh,
    const dictionary& phaseChangeProperties
)
:
    liquids_(liquids),
    equilibrium_(liquids),
    X_(scalarField(liquids.size(), 1.0/liquids.size())),
    wellMixed_(true),
    rho_(0),
    x_(X_.standard())
{
    if (size() == 1)
    {
        return;
    }
    const dictionary dict(phaseChangeProperties.subOrEmptyDict("liquid"));
    userEntry::onlyThese(dict, {"mixing"});
    wellMixed_ =
        Enum<bool>({{false, "diffusion"}, {true, "well"}}).getOrDefault
        (
            "mixing", dict, false
        );

    wordList names(liquids.names());
    for (word& name : names)
    {
        name = "X." + name;
    }
    X_.read
    (
        mesh,
        names,
        "a liquid of several species in constant/liquidProperties needs the"
        " mass fraction of each\nAdd the file, with zeroGradient on all"
        " boundaries"
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidPhase::Tboil(const scalar p) const
{
    scalar T = 0;
    for (const liquidModel& liquid : liquids_.liquids())
    {
        T = max(T, liquid.Tboil(p));
    }
    return T;
}


Foam::scalar Foam::dew::liquidPhase::rhoD
(
    const label i,
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    return
        rho_*liquids_.D(i, p, T, x)
       *(size() == 2 ? equilibrium_.activity().factor(T, x) : 1);
}


void Foam::dew::liquidPhase::onFaces
(
    const interfaceFaces& faces,
    scalarField& X
) const
{
    const label n = size();
    const label nFaces = faces.faces().size();
    X.setSize(n*nFaces);
    for (label i = 0; i < n; i++)
    {
        if (!X_.solved())
        {
            X = X_.standard()[i];
            continue;
        }
        const scalarField Xi(faces.ofLiquid(X_[i]));
        for (label k = 0; k < nFaces; k++)
        {
            X[k*n + i] = Xi[k];
        }
    }
}


void Foam::dew::liquidPhase::conductances
(
    const scalar p,
    const scalar T,
    const UList<scalar>& X,
    const scalar d,
    UList<scalar>& g
) const
{
    if (wellMixed_)
    {
        g = GREAT;
        return;
    }
    const scalarField& x = this->x(X);
    forAll(g, i)
    {
        g[i] = rhoD(i, p, T, x)/d;
    }
}


// ************************************************************************* //
