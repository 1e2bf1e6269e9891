/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "momentumExchange.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::dew::momentumExchange::schemes>
Foam::dew::momentumExchange::schemeNames
({
    {schemes::semiImplicit, "semiImplicit"},
    {schemes::explicitScheme, "explicit"},
    {schemes::none, "none"}
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::momentumExchange::momentumExchange
(
    const dictionary& dict,
    const particleMesh& map,
    const smoothing& smoothing,
    const volVectorField& U
)
:
    scheme_
    (
        schemeNames.getOrDefault("momentum", dict, schemes::semiImplicit)
    ),
    map_(map),
    smoothing_(smoothing),
    U_(U),
    source_("momentum", map, smoothing, U, dimForce*dimTime)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::momentumExchange::checkExplicit
(
    const UList<scalar>& sensitivity,
    const volScalarField& alphac,
    const volScalarField& rho
) const
{
    const fvMesh& mesh = U_.mesh();
    scalarField sum(mesh.nCells(), Zero);
    map_.scatter(sensitivity, sum);
    smoothing_.spread(sum);

    scalar worst = 0;
    label cell = -1;
    forAll(sum, celli)
    {
        const scalar share =
            sum[celli]/(alphac[celli]*rho[celli]*mesh.V()[celli]);
        if (share > worst)
        {
            worst = share;
            cell = celli;
        }
    }

    if (worst > 1)
    {
        const scalar dt = mesh.time().deltaTValue();
        FatalErrorInFunction
            << "The time step " << dt << " s is above the limit of explicit"
            << " momentum exchange at time " << mesh.time().timeName()
            << ": in cell " << cell << " at " << mesh.cellCentres()[cell]
            << " particles would take " << worst << " times the momentum the"
            << " fluid's slip holds" << nl
            << "Lower deltaT in system/controlDict to less than about "
            << dt/worst << " s, or set 'momentum semiImplicit;' in coupling"
            << " of constant/particleProperties"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::momentumExchange::correct
(
    const UList<vector>& impulse,
    const UList<scalar>& impulseSp,
    const volScalarField& alphac,
    const volScalarField& rho
)
{
    sensitivity_.setSize(impulse.size());

    if (scheme_ == schemes::semiImplicit)
    {
        sensitivity_ = impulseSp;
    }
    else
    {
        UList<scalar>& s = sensitivity_;
        s = 0;
    }

    if (scheme_ == schemes::none)
    {
        source_.correct(List<vector>(impulse.size(), vector::zero), sensitivity_);
    }
    else
    {
        source_.correct(impulse, sensitivity_);
    }

    if (scheme_ == schemes::explicitScheme)
    {
        checkExplicit(impulseSp, alphac, rho);
    }
}
