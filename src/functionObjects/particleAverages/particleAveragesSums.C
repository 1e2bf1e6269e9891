/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Sums over particles, cell by cell

#include "particleAverages.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- q_c = sum_i w_ic value(i)
template<class Type, class Value>
Field<Type> scattered
(
    const dew::particleMesh& map,
    const label nCells,
    const label n,
    const Value& value
)
{
    List<Type> values(n);
    forAll(values, i)
    {
        values[i] = value(i);
    }
    Field<Type> sums(nCells, Zero);
    map.scatter(values, sums);
    return sums;
}


//- Sums over weights, zero where nothing weighs
template<class Type>
Field<Type> ratio(Field<Type> sums, const scalarField& weights)
{
    forAll(sums, celli)
    {
        sums[celli] =
            weights[celli] > 0
          ? Type(sums[celli]/weights[celli])
          : Type(Zero);
    }
    return sums;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::dew::particleAverages::mass
(
    const particleMesh& map
) const
{
    const particleState& s = particles();
    return scattered<scalar>
    (
        map, mesh().nCells(), s.size(), [&s](label i) { return s.mass(i); }
    );
}


void Foam::dew::particleAverages::volumes
(
    const particleMesh& map,
    const scalarField& mass
)
{
    const particleState& s = particles();
    const scalarField& V = mesh().V();

    if (alpha_)
    {
        alpha_->cells() = scattered<scalar>
        (
            map, V.size(), s.size(), [&s](label i) { return s.volume(i); }
        )/V;
    }
    if (number_)
    {
        number_->cells() = scattered<scalar>
        (
            map, V.size(), s.size(), [](label) { return scalar(1); }
        )/V;
    }
    if (density_)
    {
        density_->cells() = mass/V;
    }
}


Foam::vectorField Foam::dew::particleAverages::velocity
(
    const particleMesh& map,
    const scalarField& mass
) const
{
    const particleState& s = particles();
    return ratio
    (
        scattered<vector>
        (
            map, mass.size(), s.size(),
            [&s](label i) { return s.mass(i)*s.v[i]; }
        ),
        mass
    );
}


void Foam::dew::particleAverages::temperature
(
    const particleMesh& map,
    const scalarField& mass
)
{
    const particleState& s = particles();
    T_->cells() = ratio
    (
        scattered<scalar>
        (
            map, mass.size(), s.size(),
            [&s](label i) { return s.mass(i)*s.T[i]; }
        ),
        mass
    );
}


void Foam::dew::particleAverages::fluctuations
(
    const particleMesh& map,
    const scalarField& mass,
    const vectorField& U
)
{
    struct moving
    {
        scalar mass;
        vector v;
    };

    const particleState& s = particles();
    List<moving> values(s.size());
    forAll(values, i)
    {
        values[i].mass = s.mass(i);
        values[i].v = map.toMesh(s.v[i], i);
    }

    symmTensorField sums(mass.size(), Zero);
    map.share
    (
        values,
        [&](const label celli, const scalar w, const moving& p)
        {
            sums[celli] += w*p.mass*sqr(p.v - U[celli]);
        }
    );

    if (granularTemperature_)
    {
        granularTemperature_->cells() =
            ratio(scalarField(tr(sums)/3), mass);
    }
    if (kineticStress_)
    {
        kineticStress_->cells() = sums/mesh().V().field();
    }
}


void Foam::dew::particleAverages::contacts(const particleMesh& map)
{
    List<scalar> number;
    List<symmTensor> moment;

    if (!seriesFile::particles(obr_, *this).contacts(number, moment))
    {
        FatalErrorInFunction
            << "Function object " << name() << " of type " << typeName
            << " wants contacts of particles, and their engine knows none" << nl
            << "Use 'engine liggghts;' in constant/particleProperties, or"
            << " remove contactNumber and collisionalStress from the fields"
            << exit(FatalError);
    }

    const label nCells = mesh().nCells(), n = particles().size();

    if (contactNumber_)
    {
        contactNumber_->cells() = ratio
        (
            scattered<scalar>
            (
                map, nCells, n, [&number](label i) { return number[i]; }
            ),
            scattered<scalar>
            (
                map, nCells, n, [](label) { return scalar(1); }
            )
        );
    }
    if (collisionalStress_)
    {
        // On a wedge turned as the vectors are
        if (map.symmetry().wedge())
        {
            forAll(moment, i)
            {
                const tensor turn
                (
                    map.toMesh(vector(1, 0, 0), i),
                    map.toMesh(vector(0, 1, 0), i),
                    map.toMesh(vector(0, 0, 1), i)
                );
                moment[i] = symm(turn.T() & moment[i] & turn);
            }
        }
        symmTensorField sums(nCells, Zero);
        map.share
        (
            moment,
            [&sums](const label celli, const scalar w, const symmTensor& m)
            {
                sums[celli] += w*m;
            }
        );
        collisionalStress_->cells() = sums/mesh().V().field();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::particleAverages::execute()
{
    const particleMesh& map = exchange().map();

    const scalarField m(mass(map));
    volumes(map, m);

    if (U_ || granularTemperature_ || kineticStress_)
    {
        const vectorField U(velocity(map, m));
        if (U_)
        {
            U_->cells() = U;
        }
        if (granularTemperature_ || kineticStress_)
        {
            fluctuations(map, m, U);
        }
    }
    if (T_)
    {
        temperature(map, m);
    }
    if (contactNumber_ || collisionalStress_)
    {
        contacts(map);
    }

    const scalar t = time_.value();
    const scalar dt = min(t - last_, t - averageStart_);
    last_ = t;
    if (timeAverage_ && dt > 0)
    {
        addToMeans(dt);
    }
    return true;
}
