/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heatLedger.H"
#include "fvMesh.H"
#include "heatStorage.H"
#include "interfaceTransfer.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::heatLedger::heatLedger
(
    const fvMesh& mesh,
    const interfaceTransfer& interface,
    const heatStorage& storage,
    const scalar factor
)
:
    IOdictionary
    (
        IOobject
        (
            "heat", mesh.time().timeName(), "uniform", mesh.time(),
            IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    interface_(interface),
    storage_(storage),
    factor_(factor),
    Tref_(getOrDefault<scalar>("Tref", storage.meanT())),
    start_(getOrDefault<scalar>("start", storage.held(Tref_))),
    in_(getOrDefault<scalar>("in", 0)),
    latent_(getOrDefault<scalar>("latent", 0)),
    moved_(getOrDefault<scalar>("moved", 0)),
    leaving_(getOrDefault<scalar>("leaving", 0))
{
    if (Pstream::master())
    {
        const fileName dir
        (
            mesh.time().globalPath()/"postProcessing"/"evaporation"
           /mesh.time().timeName()
        );
        mkDir(dir);
        table_.reset(new OFstream(dir/"heat.dat"));
        table_().precision(10);
        table_() << "# time stored[J] in[J] latent[J] moved[J]" << endl;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::heatLedger::throughBoundary
(
    const volScalarField& T,
    const surfaceScalarField& rhoCpPhi,
    const surfaceScalarField& kappaf
) const
{
    const auto conducted = [&](const label patchi)
    {
        return scalarField
        (
            kappaf.boundaryField()[patchi]*T.boundaryField()[patchi].snGrad()
           *mesh_.magSf().boundaryField()[patchi]
        );
    };

    scalar power = 0;
    for (const fvPatchScalarField& Tb : T.boundaryField())
    {
        const label patchi = Tb.patch().index();
        if
        (
            !Tb.coupled()
         && !polyPatch::constraintType(Tb.patch().patch().type())
        )
        {
            power += sum
            (
                conducted(patchi)
              - rhoCpPhi.boundaryField()[patchi]*(Tb - Tref_)
            );
        }
    }

    // A film on a wall takes what the wall gives, the gas beside it only a part
    List<scalarField> onPatches(T.boundaryField().size());
    for (const interfaceFace& face : interface_.faces().faces())
    {
        if (face.wall)
        {
            scalarField& values = onPatches[face.patch];
            if (values.empty())
            {
                values = conducted(face.patch);
            }
            power -= values[face.patchFace];
        }
    }

    return returnReduce(power, sumOp<scalar>()) + interface_.wallHeat();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::heatLedger::add
(
    const volScalarField& T,
    const surfaceScalarField& rhoCpPhi,
    const surfaceScalarField& kappaf,
    const scalar power
)
{
    const scalar dt = mesh_.time().deltaTValue();
    scalar latent, gas, liquid;
    interface_.heatRates(T, Tref_, latent, gas, liquid);

    in_ += (throughBoundary(T, rhoCpPhi, kappaf) + power)*dt;
    latent_ += latent*dt;
    moved_ += gas*dt - leaving_;
    leaving_ = liquid*dt;
}


void Foam::dew::heatLedger::report()
{
    const scalar stored = storage_.held(Tref_) - start_;
    const scalar error = stored - in_ + latent_ - moved_;
    const scalar most = max(max(mag(in_), mag(latent_)), mag(stored));

    Info<< "heat: stored " << factor_*stored << " J = in " << factor_*in_
        << " - latent " << factor_*latent_ << " + moved " << factor_*moved_
        << ", error " << (most > 0 ? mag(error)/most : 0) << endl;

    if (table_.valid())
    {
        table_()
            << mesh_.time().value() << ' ' << factor_*stored << ' '
            << factor_*in_ << ' ' << factor_*latent_ << ' '
            << factor_*moved_ << endl;
    }
}


bool Foam::dew::heatLedger::writeData(Ostream& os) const
{
    const int precision = os.precision(17);
    os.writeEntry("Tref", Tref_);
    os.writeEntry("start", start_);
    os.writeEntry("in", in_);
    os.writeEntry("latent", latent_);
    os.writeEntry("moved", moved_);
    os.writeEntry("leaving", leaving_);
    os.precision(precision);
    return os.good();
}


// ************************************************************************* //
