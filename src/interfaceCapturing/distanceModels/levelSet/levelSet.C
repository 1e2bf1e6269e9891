/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "levelSet.H"
#include "addToRunTimeSelectionTable.H"
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

void Foam::dew::distanceModels::levelSet::setBand
(
    const UList<labelPair>& betweenFaces
)
{
    const fvMesh& mesh = surface_.mesh();

    layer_.setSize(mesh.nCells());
    layer_ = -1;
    for (const label celli : surface_.planes().cell())
    {
        layer_[celli] = 0;
    }
    for (const labelPair& pair : betweenFaces)
    {
        layer_[pair.first()] = 0;
    }
    cellLinks::grow(mesh, nLayers, layer_);

    DynamicList<label> cells;
    forAll(layer_, celli)
    {
        if (layer_[celli] >= 0)
        {
            cells.append(celli);
        }
    }
    band_.set
    (
        cells, layer_, wallContact::faces(surface_, betweenFaces, nLayers)
    );

    dx_.setSize(cells.size());
    held_.setSize(cells.size());
    gradn_.setSize(mesh.nCells());
    gradn_ = Zero;
    forAll(cells, i)
    {
        dx_[i] = cellLinks::width(mesh, cells[i]);
        held_[i] = layer_[cells[i]] == 0;
    }

    atWalls_.clear();
    forAll(cells, i)
    {
        for (const cellLinks::link& l : band_.of(i))
        {
            if (l.patch >= 0)
            {
                atWalls_.append(i);
                break;
            }
        }
    }
}


void Foam::dew::distanceModels::levelSet::start
(
    const UList<labelPair>& betweenFaces,
    scalarField& psi
)
{
    const fvMesh& mesh = surface_.mesh();
    const interfacePlanes& planes = surface_.planes();
    const scalarField& alpha = surface_.alpha().primitiveField();

    gradient_.setSize(mesh.nCells());
    forAll(band_.cell(), i)
    {
        const label celli = band_.cell()[i];
        gradient_[celli] = Zero;
        psi[celli] = 0.75*(2*alpha[celli] - 1)*dx_[i];
    }
    forAll(planes.cell(), i)
    {
        const label celli = planes.cell()[i];
        psi[celli] = (planes.x()[i] - mesh.C()[celli]) & planes.n()[i];
        gradient_[celli] = -planes.n()[i];
    }
    for (const labelPair& pair : betweenFaces)
    {
        const label celli = pair.first();
        const vector m(normalised(mesh.faceAreas()[pair.second()]));
        psi[celli] =
            mag((mesh.faceCentres()[pair.second()] - mesh.C()[celli]) & m)
           *(alpha[celli] > 0.5 ? 1 : -1);

        const bool out = mesh.faceOwner()[pair.second()] == celli;
        gradient_[celli] = out == (alpha[celli] > 0.5) ? -m : m;
    }

    for (label layer = 1; layer <= nLayers; layer++)
    {
        fetch(psi);
        fetchGradient();
        march(layer, psi);
    }
}


void Foam::dew::distanceModels::levelSet::march
(
    const label layer,
    scalarField& psi
)
{
    List<label> layerBehind;
    cellLinks::fetch(surface_.mesh(), layer_, layerBehind);

    forAll(band_.cell(), i)
    {
        const label celli = band_.cell()[i];
        if (layer_[celli] != layer)
        {
            continue;
        }
        vector g(Zero);
        scalar sum = 0;
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
                const vector& gk = here ? gradient_[k] : gradientBehind_[k];
                sum += (here ? psi[k] : psiBehind_[k]) - (gk & l.d);
                g += gk;
                n++;
            }
        }
        if (n > 0)
        {
            gradient_[celli] = normalised(g);
            psi[celli] = sum/n;
        }
    }
}


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
        const tensor& gradn = gradn_[celli];
        const vector n
        (
            normalised
            (
                -gradient_[celli]/size + ((planes.x()[plane] - C) & gradn)
            )
        );

        cut_.set(celli);
        cut_.function(n);
        cut_.cut(alpha[celli]);
        const vector toC(C - cut_.centre());

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
    for (label i = 0; i < nCorrections; i++)
    {
        hold(psic);
        sweep(nSweepsAgain, psic);
    }
    measure(psic);

    const scalarField& alpha = surface_.alpha().primitiveField();
    forAll(layer_, celli)
    {
        if (layer_[celli] < 0)
        {
            psic[celli] =
                (alpha[celli] > 0.5 ? nLayers : -nLayers)
               *cellLinks::width(mesh, celli);
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
            const vectorField nIn(n.boundaryField()[patchi].patchInternalField());
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
