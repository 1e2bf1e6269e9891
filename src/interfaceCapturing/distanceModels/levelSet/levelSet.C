/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "levelSet.H"
#include "addToRunTimeSelectionTable.H"
#include "cellWidth.H"
#include "transportedSurface.H"
#include "userEntry.H"
#include "wallContact.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace distanceModels
{
    defineTypeName(levelSet);
    addToRunTimeSelectionTable(distanceModel, levelSet, dictionary);
}
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of the pseudo-time: from the start, after each change of the held cells
constexpr Foam::label nSweeps = 6, nSweepsAgain = 4;

constexpr Foam::label nCorrections = 4;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::distanceModels::levelSet::levelSet
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    distanceModel(surface),
    cut_(surface.mesh()),
    band_(surface.mesh())
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::distanceModels::levelSet::hold(scalarField& psi)
{
    const fvMesh& mesh = surface_.mesh();
    const interfacePlanes& planes = surface_.planes();
    const scalarField& alpha = surface_.alpha().primitiveField();

    calculateGradientOfNormal(psi);
    forAll(band_.cell(), i)
    {
        const label celli = band_.cell()[i];
        const label plane = planes.of(celli);
        const scalar size = mag(gradient_[celli]);
        if (plane < 0 || size < SMALL)
        {
            continue;
        }
        const point& C = mesh.C()[celli];

        // A bend sharper than the cell says nothing
        const tensor gradn
        (
            mag(gradn_[celli])*dx_[i] < 1 ? gradn_[celli] : tensor(Zero)
        );
        const vector n
        (
            normalised
            (
                -gradient_[celli]/size + ((planes.x()[plane] - C) & gradn)
            )
        );

        cut_.set(celli);
        cut_.cutPlane(n, alpha[celli], near_[plane]);
        near_[plane] = cut_.centre();
        const vector toC(C - near_[plane]);

        const scalar a = (toC & n) - 0.5*(cut_.spread() && gradn);
        const vector s(toC - (toC & n)*n);
        const scalar bend = s & gradn & s;
        const scalar sagitta = 0.5*bend/(1 + a*bend/max(magSqr(s), VSMALL));
        psi[celli] = -(a + sagitta);
    }
}


void Foam::dew::distanceModels::levelSet::measure(const scalarField& psi)
{
    const fvMesh& mesh = surface_.mesh();
    const interfacePlanes& planes = surface_.planes();

    scalar sum = 0;
    steepest_ = 0;
    label n = 0;
    forAll(band_.cell(), i)
    {
        const label celli = band_.cell()[i];
        const label plane = planes.of(celli);
        if (plane >= 0)
        {
            const vector d(planes.x()[plane] - mesh.C()[celli]);
            sum += mag(psi[celli] + (gradient_[celli] & d))/dx_[i];
            n++;
        }
        if (mag(psi[celli]) < 3*dx_[i])
        {
            steepest_ = max(steepest_, mag(mag(gradient_[celli]) - 1));
        }
    }
    reduce(sum, sumOp<scalar>());
    reduce(n, sumOp<label>());
    reduce(steepest_, maxOp<scalar>());
    moved_ = sum/max(n, 1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::distanceModels::levelSet::correct
(
    volScalarField& psi,
    volVectorField& n
)
{
    const fvMesh& mesh = surface_.mesh();
    scalarField& psic = psi.primitiveFieldRef();
    const List<labelPair> pairs(wallContact::betweenFaces(surface_));

    setBand(pairs);
    start(pairs, psic);
    sweep(nSweeps, psic);
    near_ = surface_.planes().x();
    for (label i = 0; i < nCorrections; i++)
    {
        hold(psic);
        sweep(nSweepsAgain, psic);
    }
    measure(psic);

    const scalarField& alpha = surface_.alpha().primitiveField();
    const scalarField& width = cellWidth::of(mesh);
    forAll(layer_, celli)
    {
        if (layer_[celli] < 0)
        {
            psic[celli] =
                (alpha[celli] > 0.5 ? nLayers : -nLayers)*width[celli];
            n[celli] = Zero;
        }
        else
        {
            n[celli] = -normalised(gradient_[celli]);
        }
    }

    psi.correctBoundaryConditions();
    n.correctBoundaryConditions();
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (!patch.coupled())
        {
            const vectorField nIn
            (
                n.boundaryField()[patchi].patchInternalField()
            );
            n.boundaryFieldRef()[patchi] = nIn;
            psi.boundaryFieldRef()[patchi] =
                psi.boundaryField()[patchi].patchInternalField()
              - (nIn & (patch.Cf() - patch.Cn()));
        }
    }
}


void Foam::dew::distanceModels::levelSet::report(Ostream& os) const
{
    os  << "Level set: off the planes by " << moved_
        << " dx in the mean, | |grad psi| - 1 | at most " << steepest_ << endl;
}
