/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "UNIFAC.H"
#include "addToRunTimeSelectionTable.H"
#include "speciesData.H"
#include "UNIFACGroups.H"
#include "userEntry.H"

#include <cmath>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace activityModels
{
    defineTypeName(UNIFAC);
    addToRunTimeSelectionTable(activityModel, UNIFAC, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::activityModels::UNIFAC::UNIFAC
(
    const dictionary& dict,
    const liquidMixture& liquids
)
:
    activityModel(liquids),
    r_(n_, 0),
    q_(n_, 0)
{
    userEntry::onlyThese(dict, {"type", "groups"});
    const dictionary& groups = userEntry::optionalDict(dict, "groups");
    userEntry::onlyThese(groups, liquids.names());

    List<DynamicList<label>> of(n_);
    List<DynamicList<scalar>> count(n_);
    for (label i = 0; i < n_; i++)
    {
        readGroups(groups, i, liquids, of[i], count[i]);
        for (const label g : of[i])
        {
            if (!groups_.found(g))
            {
                groups_.append(g);
            }
        }
    }

    const label m = groups_.size();
    v_.setSize(n_*m, 0);
    E_.setSize(m*m);
    O_.setSize(m);
    sum_.setSize(m);
    lnG_.setSize(m);
    pure_.setSize(m);
    for (label i = 0; i < n_; i++)
    {
        forAll(of[i], k)
        {
            const UNIFACGroups::group& g = UNIFACGroups::get(of[i][k]);
            v_[i*m + groups_.find(of[i][k])] += count[i][k];
            r_[i] += count[i][k]*g.R;
            q_[i] += count[i][k]*g.Q;
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::activityModels::UNIFAC::readGroups
(
    const dictionary& groups,
    const label i,
    const liquidMixture& liquids,
    DynamicList<label>& of,
    DynamicList<scalar>& count
)
{
    const word& name = liquids.names()[i];
    if (groups.found(name))
    {
        const dictionary& given = userEntry::subDict(groups, name);
        for (const word& g : given.toc())
        {
            of.append(UNIFACGroups::index(g, given));
            count.append(userEntry::count(given, g));
        }
        return;
    }

    const speciesData* species = speciesData::find(liquids.liquid(i).name());
    if (!species || !*species->groups)
    {
        FatalIOErrorInFunction(groups)
            << "No UNIFAC groups are known of the liquid " << name << nl
            << "Give, e.g., groups { " << name << " { CH3 1; CH2 3; OH 1; } }"
            << exit(FatalIOError);
    }
    std::istringstream is(species->groups);
    label number;
    std::string g;
    while (is >> number >> g)
    {
        of.append(UNIFACGroups::index(g, groups));
        count.append(number);
    }
}


void Foam::dew::activityModels::UNIFAC::residual(scalarField& lnG) const
{
    const label m = groups_.size();

    scalar total = 0;
    for (label k = 0; k < m; k++)
    {
        O_[k] *= UNIFACGroups::get(groups_[k]).Q;
        total += O_[k];
    }
    for (label k = 0; k < m; k++)
    {
        O_[k] /= total;
    }
    for (label k = 0; k < m; k++)
    {
        sum_[k] = 0;
        for (label l = 0; l < m; l++)
        {
            sum_[k] += O_[l]*E_[l*m + k];
        }
    }
    for (label k = 0; k < m; k++)
    {
        lnG[k] = 1 - std::log(sum_[k]);
        for (label l = 0; l < m; l++)
        {
            lnG[k] -= O_[l]*E_[k*m + l]/sum_[l];
        }
        lnG[k] *= UNIFACGroups::get(groups_[k]).Q;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::activityModels::UNIFAC::lnGamma
(
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& result
) const
{
    const label m = groups_.size();
    scalar amount = 0, volume = 0, surface = 0, l = 0;
    for (label i = 0; i < n_; i++)
    {
        amount += x[i];
        volume += x[i]*r_[i];
        surface += x[i]*q_[i];
        l += x[i]*(5*(r_[i] - q_[i]) - (r_[i] - 1));
    }
    volume /= amount;
    surface /= amount;
    l /= amount;

    for (label k = 0; k < m; k++)
    {
        for (label j = 0; j < m; j++)
        {
            E_[k*m + j] =
                std::exp(-UNIFACGroups::a(groups_[k], groups_[j])/T);
        }
        O_[k] = 0;
        for (label i = 0; i < n_; i++)
        {
            O_[k] += x[i]*v_[i*m + k];
        }
    }
    residual(lnG_);

    for (label i = 0; i < n_; i++)
    {
        const scalar P = r_[i]/volume, Q = q_[i]/surface;
        result[i] =
            std::log(P) + 5*q_[i]*std::log(Q/P)
          + 5*(r_[i] - q_[i]) - (r_[i] - 1) - P*l;

        for (label k = 0; k < m; k++)
        {
            O_[k] = v_[i*m + k];
        }
        residual(pure_);
        for (label k = 0; k < m; k++)
        {
            result[i] += v_[i*m + k]*(lnG_[k] - pure_[k]);
        }
    }
}
