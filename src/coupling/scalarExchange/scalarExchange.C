/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "scalarExchange.H"
#include "exponentialRelaxation.H"
#include "linearGradient.H"
#include "Time.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::dew::scalarExchange::schemes>
Foam::dew::scalarExchange::schemeNames
({
    {schemes::semiImplicit, "semiImplicit"},
    {schemes::none, "none"}
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::scalarExchange::scalarExchange
(
    const dictionary& dict,
    const volScalarField& c,
    const particleMesh& map,
    const smoothing& smoothing,
    const particleState& state
)
:
    name_(c.name()),
    c_(c),
    map_(map),
    state_(state),
    D_(userEntry::positive(dict, "diffusivity", dimArea/dimTime)),
    Sct_(userEntry::positiveOr(dict, "Sct", dimless, 0.7)),
    partition_(userEntry::notNegativeOr(dict, "partition", dimless, 1)),
    initial_(userEntry::number(dict, "initial", c.dimensions())),
    transfer_(heatTransferModel::New(userEntry::subDict(dict, "transfer"))),
    scheme_(schemeNames.getOrDefault("exchange", dict, schemes::semiImplicit)),
    source_(name_, map, smoothing, c, c.dimensions()*dimVolume),
    first_(0),
    stride_(N_VALUES)
{
    userEntry::onlyThese
    (
        dict,
        {
            "diffusivity", "Sct", "partition", "initial", "transfer",
            "exchange"
        }
    );
    ranges_.add(transfer_->type() + " of " + name_, transfer_->ranges());
}


Foam::PtrList<Foam::dew::scalarExchange> Foam::dew::scalarExchange::all
(
    const dictionary& coupling,
    const carrierFields& fluid,
    const particleMesh& map,
    const smoothing& smoothing,
    const particleState& state
)
{
    const dictionary& dict = userEntry::optionalDict(coupling, "scalars");
    PtrList<scalarExchange> result;

    for (const entry& e : dict)
    {
        if (!fluid.scalars)
        {
            FatalIOErrorInFunction(coupling)
                << "Entry 'scalars' needs a solver with equations of scalars"
                << nl << "Use cfdDemFoam, or remove the entry"
                << exit(FatalIOError);
        }
        const dictionary& scalarDict = userEntry::dictOf(dict, e);
        for (const volScalarField& c : *fluid.scalars)
        {
            if (c.name() == e.keyword())
            {
                result.append
                (
                    new scalarExchange(scalarDict, c, map, smoothing, state)
                );
            }
        }
    }

    return result;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::scalarExchange::value
(
    const UList<scalar>& memory,
    const label i
) const
{
    const scalar* m = memory.cdata() + stride_*i + first_;

    return (m[KNOWN] ? m[CP] : initial_) + kick_[i]/state_.volume(i);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::scalarExchange::gather(const bool linear)
{
    tmp<vectorField> gradient;
    if (linear)
    {
        gradient = linearGradient(c_, map_.symmetry());
    }
    const vectorField& C = c_.mesh().C();

    here_.setSize(state_.size());
    UList<scalar>& here = here_;
    here = 0;

    map_.gatherHosted
    (
        here,
        [&](const label celli, const point& x, scalar& c)
        {
            c = c_[celli];
            if (linear)
            {
                c += (x - C[celli]) & gradient()[celli];
            }
        }
    );
    ranges_.restart();
}


void Foam::dew::scalarExchange::evolve
(
    const label i,
    const particle& p,
    const carrier& c,
    UList<scalar>& memory
)
{
    scalar* m = memory.data() + stride_*i + first_;

    m[CP] = value(memory, i);
    m[KNOWN] = 1;
    m[RECEIVED] = 0;
    m[SENSITIVITY] = 0;

    // Outside the mesh there is no fluid
    if (c.rho <= 0)
    {
        return;
    }

    // Heat with rho Cp = 1 and kappa = D: then Nu is Sh, and Pr is Sc
    carrier solvent(c);
    solvent.kappa = D_;
    solvent.Cp = 1/c.rho;
    ranges_.count(p, solvent);

    const scalar dt = c.deltaT, V = p.volume();
    const scalar k = transfer_->Qp(p, solvent);
    const scalar s = k*dt*phi1(partition_*k*dt/V);
    const scalar J = s*(here_[i] - partition_*m[CP]);

    m[CP] += J/V;
    m[RECEIVED] = J;
    m[SENSITIVITY] = s;
}


void Foam::dew::scalarExchange::correct(const UList<scalar>& memory)
{
    const label n = state_.size();
    List<scalar> received(n, scalar(0));
    sensitivity_.setSize(n);
    for (label i = 0; i < n; i++)
    {
        const scalar* m = memory.cdata() + stride_*i + first_;
        received[i] = twoWay() ? m[RECEIVED] : 0;
        sensitivity_[i] = twoWay() ? m[SENSITIVITY] : 0;
    }
    source_.correct(received, sensitivity_);
    kick_.setSize(n);
    UList<scalar>& kick = kick_;
    kick = 0;
}


void Foam::dew::scalarExchange::updateKicks() const
{
    source_.kicks(sensitivity_, kick_);
}


Foam::List<Foam::scalar> Foam::dew::scalarExchange::values
(
    const UList<scalar>& memory
) const
{
    List<scalar> result(state_.size());
    forAll(result, i)
    {
        result[i] = value(memory, i);
    }
    return result;
}


Foam::dew::exchangeLedger::amounts Foam::dew::scalarExchange::balance
(
    const UList<scalar>& memory
) const
{
    // Held, received, sum of magnitudes
    vector sum(Zero);
    for (label i = 0; i < state_.size(); i++)
    {
        const scalar J =
            twoWay() ? memory[stride_*i + first_ + RECEIVED] : scalar(0);
        sum += vector
        (
            state_.volume(i)*value(memory, i),
            J + kick_[i],
            mag(J) + mag(kick_[i])
        );
    }
    reduce(sum, sumOp<vector>());

    return {name_, sum.x(), sum.y(), source_.lost(), sum.z()};
}
