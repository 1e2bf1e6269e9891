/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gasPressure.H"
#include "fvMesh.H"
#include "gasMixture.H"
#include "gasPhase.H"
#include "Time.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

bool closedIn(const Foam::fvMesh& mesh)
{
    using namespace Foam;

    label nOpen = 0;
    for (const fvPatch& patch : mesh.boundary())
    {
        if
        (
            !polyPatch::constraintType(patch.patch().type())
         && !isA<wallFvPatch>(patch)
        )
        {
            nOpen += patch.size();
        }
    }

    return !returnReduce(nOpen, sumOp<label>());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::gasPressure::gasPressure
(
    const fvMesh& mesh,
    const gasMixture& model
)
:
    IOdictionary
    (
        IOobject
        (
            "gasPressure", mesh.time().timeName(), "uniform", mesh.time(),
            IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    model_(model),
    closedIn_(closedIn(mesh)),
    closed_(closedIn_ && !model.uniformDensity()),
    p0_(getOrDefault<scalar>("p0", model.p0())),
    before_(p0_),
    timeIndex_(-1),
    carrier_(getOrDefault<scalar>("carrier", -1))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::gasPressure::start(const gasPhase& gas, const bool vapour)
{
    closed_ = closed_ && gas.isTransient();

    if (closedIn_ && !closed_ && vapour)
    {
        FatalErrorInFunction
            << "The gas is closed in: no patch of the mesh is of type 'patch',"
            << " and what evaporates raises the pressure of the gas" << nl
            << "Use 'type idealGas;' in constant/gasProperties with 'gas"
            << " transient;' in constant/phaseChangeProperties, or make a"
            << " boundary of the gas a 'patch' in"
            << " constant/polyMesh/boundary (blockMeshDict)"
            << exit(FatalError);
    }

    if (closed_ && carrier_ < 0)
    {
        carrier_ = gas.heldGas() - gas.held();
    }
}


void Foam::dew::gasPressure::correct(gasPhase& gas, const scalar rate)
{
    if (closed_)
    {
        if (timeIndex_ != mesh_.time().timeIndex())
        {
            timeIndex_ = mesh_.time().timeIndex();
            before_ = p0_;
        }
        gas.correct();
        p0_ *=
            (carrier_ + gas.held() + rate*mesh_.time().deltaTValue())
           /gas.mass();
    }
}


Foam::scalar Foam::dew::gasPressure::rate() const
{
    return (p0_ - before_)/mesh_.time().deltaTValue();
}


void Foam::dew::gasPressure::report() const
{
    if (closed_)
    {
        Info<< "p0 " << p0_ << " Pa, carrier " << carrier_ << " kg" << endl;
    }
}


bool Foam::dew::gasPressure::writeData(Ostream& os) const
{
    const int precision = os.precision(17);
    os.writeEntry("p0", p0_);
    os.writeEntry("carrier", carrier_);
    os.precision(precision);
    return os.good();
}


// ************************************************************************* //
